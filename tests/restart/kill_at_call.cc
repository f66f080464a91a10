// SPDX-License-Identifier: LGPL-2.1-or-later
// Preloaded (LD_PRELOAD): kill -9 just before call number KILL_AT of those that
// change names of files, of which one holds the text KILL_IN.
#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace
{
  void
  count(const char *name)
  {
    static int  calls = 0;
    const char *text  = std::getenv("KILL_IN");
    const char *at    = std::getenv("KILL_AT");
    if (text != nullptr && at != nullptr &&
        std::strstr(name, text) != nullptr && ++calls == std::atoi(at))
      kill(getpid(), SIGKILL);
  }

  template <typename Function>
  Function
  next(const char *name)
  {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
  }
} // namespace

extern "C" int
rename(const char *from, const char *to) noexcept
{
  count(from);
  return next<int (*)(const char *, const char *)>("rename")(from, to);
}

extern "C" int
mkdir(const char *name, mode_t mode) noexcept
{
  count(name);
  return next<int (*)(const char *, mode_t)>("mkdir")(name, mode);
}

extern "C" int
remove(const char *name) noexcept
{
  count(name);
  return next<int (*)(const char *)>("remove")(name);
}
