# shellcheck shell=bash
# For tests that install what was made where nothing else is: source packaging/bare_root.sh, then
#   make_bare_root RELEASE   a bare Debian in $bare, which goes when the test ends
#   inside COMMANDS          runs them there, in /root, with no more than a login has
#   fail TEXT
# Needs root, debootstrap and the network; MIRROR names another mirror, BARE a root that was made
# before, to be copied.
mirror=${MIRROR:-http://deb.debian.org/debian}
work=$(mktemp -d)
bare=$work/root
trap 'rm -rf --one-file-system "$work"' EXIT

fail() {
  echo "$(basename "$0"): $1" >&2
  exit 1
}

quietly() {
  "$@" >"$work/log" 2>&1 || { tail -n 40 "$work/log" >&2; fail "failed: $*"; }
}

make_bare_root() {
  [ "$(id -u)" -eq 0 ] || fail "expected to be root, which chroot needs"
  if [ -n "${BARE:-}" ]; then
    cp -a "$BARE" "$bare"
  else
    quietly debootstrap --variant=minbase "$1" "$bare" "$mirror"
  fi
}

# Mounts end with the process that needs them.
inside() {
  unshare --mount --propagation private bash -c \
    'mount -t proc proc "$0/proc" && exec chroot "$0" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin \
     DEBIAN_FRONTEND=noninteractive bash -euc "cd /root; $1"' "$bare" "$1"
}
