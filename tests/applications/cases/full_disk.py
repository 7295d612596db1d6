"""A disk with too little room for one more checkpoint.

Where this process may mount, the disk is a small tmpfs in a namespace of its
own. Elsewhere no file may grow past half the size of the largest checkpoint
file, which the application sees as a failing write just as well.
"""

import contextlib
import ctypes
import os
import resource
import shutil
import signal
import subprocess
import sys

NAMESPACE = "CONTRECOUP_TEST_NAMESPACE"


def enter_namespace():
    """Starts this program again where it may mount, if that is allowed."""
    if NAMESPACE in os.environ:
        return
    mount = ["unshare", "--map-root-user", "--mount"]
    probe = subprocess.run(mount + ["mount", "-t", "tmpfs", "tmpfs", "/mnt"],
                           stdin=subprocess.DEVNULL, capture_output=True)
    if probe.returncode == 0:
        os.environ[NAMESPACE] = "1"
        os.execvp("unshare", mount + [sys.executable] + sys.argv)


def sizes(folder):
    return [os.path.getsize(os.path.join(here, name))
            for here, _, names in os.walk(folder) for name in names]


@contextlib.contextmanager
def nearly_full(output, checkpoint):
    """Yields the folder to run in, which holds the files of @p output and has
    room for half of @p checkpoint, and the function that sets the limits of
    the process to be started."""
    if NAMESPACE not in os.environ:
        yield output, lambda: limit_files(max(sizes(checkpoint)) // 2)
        return
    disk = os.path.abspath(output) + "_disk"
    os.makedirs(disk)
    room = 4 * sum(sizes(output)) + (64 << 20)
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={room}", "tmpfs",
                    disk], check=True)
    try:
        folder = os.path.join(disk, "run")
        shutil.copytree(output, folder)
        free = shutil.disk_usage(disk).free - sum(sizes(checkpoint)) // 2
        with open(os.path.join(disk, "ballast"), "wb") as ballast:
            os.posix_fallocate(ballast.fileno(), 0, free)
        print(f"tmpfs with {shutil.disk_usage(disk).free} bytes free")
        yield folder, lambda: None
        shutil.rmtree(output)
        shutil.copytree(folder, output)
    finally:
        subprocess.run(["umount", "--lazy", disk], check=True)


def limit_files(size, ignore=True):
    """Lets writes beyond @p size bytes of a file fail; unless @p ignore, they
    kill who does not see to that. MPI must not lay its shared memory out in
    files then; between interfaces with addresses of IPv6, other than the
    loopback, Open MPI 5 finds no way."""
    signal.signal(signal.SIGXFSZ,
                  signal.SIG_IGN if ignore else signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    os.environ["OMPI_MCA_btl"] = "self,tcp"
    os.environ["OMPI_MCA_btl_tcp_if_include"] = "lo"
    os.environ["PMIX_MCA_gds"] = "hash"


def limit_running(process, size):
    """As limit_files() for a process that runs, and for all that it started."""
    waiting = [process.pid]
    while waiting:
        number = waiting.pop()
        try:
            resource.prlimit(number, resource.RLIMIT_FSIZE, (size, size))
            with open(f"/proc/{number}/task/{number}/children",
                      encoding="ascii") as file:
                waiting += map(int, file.read().split())
        except (ProcessLookupError, FileNotFoundError):
            continue  # it has ended


def obey_permissions():
    """Takes from root, before another program begins, the right to write where
    permissions forbid it: CAP_DAC_OVERRIDE and CAP_DAC_READ_SEARCH leave the
    bounding set (PR_CAPBSET_DROP)."""
    if os.geteuid() != 0:
        return
    system = ctypes.CDLL(None, use_errno=True)
    for capability in (1, 2):
        if system.prctl(24, capability, 0, 0, 0) != 0:
            raise OSError(ctypes.get_errno(), "cannot drop a capability")


@contextlib.contextmanager
def small_disk(output, size):
    """Yields a folder in a disk of @p size bytes (elsewhere: one where no file
    may be larger than a tenth of that), the function that sets the limits of
    the process to be started, and one that makes room."""
    if NAMESPACE not in os.environ:
        limits = {"size": size // 10}
        yield (output, lambda: limits["size"] and limit_files(limits["size"]),
               lambda: limits.update(size=0))
        return
    disk = os.path.abspath(output) + "_disk"
    os.makedirs(disk)
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs",
                    disk], check=True)
    try:
        yield (os.path.join(disk, "run"), lambda: None,
               lambda: subprocess.run(["mount", "-o", "remount,size=1G", disk],
                                      check=True))
    finally:
        subprocess.run(["umount", "--lazy", disk], check=True)
