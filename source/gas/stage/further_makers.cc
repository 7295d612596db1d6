// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/stage/further_makers.h>

#include <dlfcn.h>

namespace contrecoup::gas
{
const OperatorMakers &further_makers(const std::string &scheme,
                                     const std::string &choice)
{
  const std::string own = "contrecoup_gas";
  Dl_info here;
  dladdr(reinterpret_cast<const void *>(&further_makers), &here);
  std::string path = here.dli_fname;
  path.replace(path.rfind(own), own.size(), "contrecoup_further_schemes");
  // Opening it again is cheap; it stays until the end of the program.
  void *const library = dlopen(path.c_str(), RTLD_NOW);
  const void *const makers =
    library ? dlsym(library, ("contrecoup_" + scheme + "_makers").c_str())
            : nullptr;
  if (!makers)
    throw InputError(choice +
                     " needs a library that is built with blast: " + dlerror());
  return *static_cast<const OperatorMakers *>(makers);
}
} // namespace contrecoup::gas
