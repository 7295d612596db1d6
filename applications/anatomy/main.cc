// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/application/anatomy_application.h>
#include <contrecoup/io/application/tool.h>

int main(int argc, char **argv)
{
  return contrecoup::io::run_tool(
    argc, argv, contrecoup::coupling::anatomy_application());
}
