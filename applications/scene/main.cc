// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/scene/scene_application.h>
#include <contrecoup/io/application/application.h>

int main(int argc, char **argv)
{
  return contrecoup::io::run_with_mpi(
    argc, argv, contrecoup::coupling::run_scene);
}
