"""What a command took, for the tables beside."""
import subprocess
import sys

# Runs a command and says on standard error what it took: a process of little memory, since a new
# one begins with its parent's.
SPAWN = """import os, sys
pid = os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ, file_actions=[(os.POSIX_SPAWN_OPEN, 2, "/dev/null", os.O_WRONLY, 0)])
_, status, usage = os.wait4(pid, 0)
print(usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, os.waitstatus_to_exitcode(status), file=sys.stderr)"""


def taken(command):
    """Processor seconds, the most memory in MB, exit code, standard output."""
    ended = subprocess.run([sys.executable, "-S", "-c", SPAWN, *command], capture_output=True, text=True, check=True)
    seconds, memory, code = ended.stderr.split()
    return float(seconds), float(memory), int(code), ended.stdout
