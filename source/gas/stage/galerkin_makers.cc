// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/stage/galerkin_makers.h>

#include <dlfcn.h>

namespace contrecoup::gas
{
const GalerkinMakers &galerkin_makers()
{
  static const void *const makers = [] {
    const std::string own = "contrecoup_gas";
    Dl_info here;
    dladdr(reinterpret_cast<const void *>(&galerkin_makers), &here);
    std::string path = here.dli_fname;
    path.replace(path.rfind(own), own.size(), "contrecoup_galerkin");
    void *const library = dlopen(path.c_str(), RTLD_NOW);
    const void *const found =
      library ? dlsym(library, "contrecoup_galerkin_makers") : nullptr;
    if (!found)
      throw InputError(
        std::string("Method/Scheme = discontinuous galerkin "
                    "needs a library that is built with blast: ") +
        dlerror());
    return found;
  }();
  return *static_cast<const GalerkinMakers *>(makers);
}
} // namespace contrecoup::gas
