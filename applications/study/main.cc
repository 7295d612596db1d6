// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/io/application/tool.h>
#include <contrecoup/study/study_application.h>

int main(int argc, char **argv)
{
  return contrecoup::io::run_tool(
    argc, argv, contrecoup::study::study_application());
}
