# shellcheck shell=bash disable=SC2154
# Shell functions shared by applications/quickstart and tests/run. The caller
# has set: program (its name), root (the repository), log (a file for details).

# say TEXT...: one line for the user, also in the log.
say() {
  printf '%s: %s\n' "$program" "$*" | tee -a "$log"
}

# fail TEXT...: prints one line on stderr and exits.
fail() {
  printf '%s: %s\n' "$program" "$*" | tee -a "$log" >&2
  exit 1
}

# quietly COMMAND...: runs it with output to the log alone and without input.
quietly() {
  printf '+ %s\n' "$*" >>"$log"
  "$@" >>"$log" 2>&1 </dev/null
}

# missing_packages KIND...: the Debian packages of these kinds (second column
# of source/cmake/debian_packages.txt) that are not installed.
missing_packages() {
  local package kind
  while read -r package kind; do
    case " $* " in
      *" $kind "*)
        dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null |
          grep -qx installed || echo "$package" ;;
    esac
  done < <(grep -v '^#' "$root/source/cmake/debian_packages.txt")
}

# install_packages KIND...: installs what is missing, with apt-get alone.
install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    say "not a Debian system: taking it that the packages of" \
      "source/cmake/debian_packages.txt are there under other names"
    return
  fi
  local missing as_root=()
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -eq 0 ] && return
  local advice="apt-get install --no-install-recommends ${missing[*]}"
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail "Debian packages are missing; as root, run: $advice"
    as_root=(sudo)
  fi
  say "installing ${#missing[@]} Debian packages: ${missing[*]}"
  as_root+=(env DEBIAN_FRONTEND=noninteractive)
  quietly "${as_root[@]}" apt-get update ||
    fail "apt-get update failed; see $log"
  quietly "${as_root[@]}" apt-get install --yes --no-install-recommends \
    "${missing[@]}" || fail "could not install packages (see $log): $advice"
}

# cores: how many processor cores this process may use. nproc alone would count
# the threads of OMP_NUM_THREADS, which is often 1 for MPI, as below.
cores() {
  env -u OMP_NUM_THREADS -u OMP_THREAD_LIMIT nproc
}

# build_jobs: number of parallel compilers; one for each core that has
# 6 GB of memory.
build_jobs() {
  local cores memory
  cores=$(cores)
  memory=$(awk '/^MemTotal/ {print int($2 / 6e6)}' /proc/meminfo)
  [ "$memory" -lt "$cores" ] && cores=$memory
  [ "$cores" -lt 1 ] && cores=1
  echo "$cores"
}

# configure: lets CMake look at this machine, for the release preset.
configure() {
  say "configuring in $root/build"
  quietly cmake --preset release ||
    fail "configuring failed; see $log"
}

# build TARGET...: builds these targets with the release preset.
build() {
  local jobs
  jobs=$(build_jobs)
  say "building with $jobs compiler(s) at once"
  local watcher=
  if [ -t 1 ]; then
    watch_build &
    watcher=$!
  fi
  local ok=yes
  quietly cmake --build --preset release -j "$jobs" --target "$@" ||
    ok=no
  [ -z "$watcher" ] || kill "$watcher"
  [ $ok = yes ] || fail "building failed; see $log"
}

# watch_build: shows the number of compiled files on a terminal.
watch_build() {
  while sleep 1; do
    printf '\r%s ' "$(grep -o '^\[[0-9]*/[0-9]*\]' "$log" | tail -n 1)"
  done
}

# Settings under which mpirun works on one machine, whatever its network, in
# containers and as root; Open MPI 5 has the name that begins with PRTE.
allow_mpi_anywhere() {
  export OMPI_MCA_btl=^tcp,uct,openib,ofi OMPI_MCA_pml=ob1
  export OMPI_MCA_btl_vader_single_copy_mechanism=none
  export OMPI_MCA_rmaps_base_oversubscribe=1
  export PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe
  export OMP_NUM_THREADS=1
  if [ "$(id -u)" -eq 0 ]; then
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  fi
}
