#!/bin/sh
# Runs a command in a fresh clone on a bare Debian 12 that has nothing but python3, make and git.
#
#   tools/fresh_machine.sh make demo              as root, without any GL library
#   tools/fresh_machine.sh --gl egl make test     with libegl1; --gl osmesa: with libosmesa6; --gl both
#   tools/fresh_machine.sh --user make test       as an ordinary user
#   tools/fresh_machine.sh --offline make test    with a loopback interface only: no network and no multicast
#   tools/fresh_machine.sh --no-multicast ...     the same, but the first `make` may use the network
#
# --keep DIR uses the machine in DIR, and makes it there the first time; else a temporary one is removed at the end.
# The clone of an earlier run in DIR is brought to HEAD.
# With --offline, DIR must have run the command once with a network. The committed state of HEAD is what is tested.
# Needs root and debootstrap (apt-get install debootstrap). apt, pip and certificates are configured as on this machine.
set -eu
unset PIP_FIND_LINKS # a folder of this machine

# The mounts are in a mount namespace of their own: nothing of them reaches this machine, and they end with this script.
[ "${FRESH_MACHINE_MOUNTS-}" = private ] || [ "$(id -u)" != 0 ] ||
    exec env FRESH_MACHINE_MOUNTS=private unshare --mount --propagation private "$0" "$@"

usage() { sed -n '2,/^set/s/^# \{0,1\}//p' "$0" | sed '/^set/d' >&2; exit 2; }
say() { printf '%s\n' "fresh_machine: $*" >&2; }

gl=none user=root network=yes keep=
while [ $# -gt 0 ]; do
    case $1 in
    --gl) gl=$2; shift 2 ;;
    --user) user=tester; shift ;;
    --offline) network=no; shift ;;
    --no-multicast) network=first; shift ;;
    --keep) keep=$2; shift 2 ;;
    -*) usage ;;
    *) break ;;
    esac
done
[ $# -gt 0 ] || usage
case $gl in none | egl | osmesa | both) ;; *) usage ;; esac
[ "$(id -u)" = 0 ] || { say "needs root, for debootstrap and chroot"; exit 1; }
command -v debootstrap >/dev/null || { say "needs debootstrap: apt-get install debootstrap"; exit 1; }

source=$(cd "$(dirname "$0")/.." && pwd)
machine=${keep:-$(mktemp -d /tmp/fresh-XXXXXX)}
finish() {
    umount -l "$machine/dev/shm" "$machine/dev/pts" "$machine/dev" "$machine/proc" 2>/dev/null || : # before anything is removed
    [ -n "$keep" ] || rm -rf "$machine"
}
trap finish EXIT

if [ ! -e "$machine/.made" ]; then
    say "making a Debian 12 in $machine"
    debootstrap --variant=minbase --include=python3,make,git,ca-certificates bookworm "$machine" http://deb.debian.org/debian >"$machine.log" 2>&1 ||
        { tail -5 "$machine.log" >&2; exit 1; }
    rm -f "$machine.log"
    chroot "$machine" useradd -m tester
    touch "$machine/.made"
fi
mkdir -p "$machine/proc" "$machine/dev"
mount -t proc proc "$machine/proc"
mount --bind /dev "$machine/dev"
mount -t devpts -o newinstance,ptmxmode=0666,mode=0620,gid=5 devpts "$machine/dev/pts"
[ -d "$machine/dev/shm" ] && mount -t tmpfs -o mode=1777 tmpfs "$machine/dev/shm"

# how this machine reaches its registries
cp /etc/resolv.conf "$machine/etc/"
cp /etc/ssl/certs/ca-certificates.crt "$machine/etc/ssl/certs/" 2>/dev/null || :
for each in /etc/apt/apt.conf.d/99*; do [ ! -e "$each" ] || cp "$each" "$machine/etc/apt/apt.conf.d/"; done
[ ! -e /etc/pip.conf ] || cp /etc/pip.conf "$machine/etc/pip.conf"

case $gl in
none) packages= ;;
egl) packages=libegl1 ;;
osmesa) packages=libosmesa6 ;;
both) packages='libegl1 libosmesa6' ;;
esac
if [ -n "$packages" ]; then
    say "installing $packages"
    # shellcheck disable=SC2086
    { chroot "$machine" apt-get update -q && chroot "$machine" apt-get install -qy --no-install-recommends $packages; } >/dev/null
fi
if [ "$user" != root ]; then # an ordinary user cannot install it
    { chroot "$machine" apt-get update -q && chroot "$machine" apt-get install -qy --no-install-recommends python3-venv; } >/dev/null
fi

home=/root
[ "$user" = root ] || home=/home/$user
clone=$machine$home/jauspy
if [ ! -d "$clone" ]; then
    git clone -q --no-hardlinks "$source" "$clone"
else # of an earlier run: what git ignores stays, as in the clone of somebody who pulls
    git -c safe.directory='*' -C "$clone" fetch -q "$source" HEAD
    git -c safe.directory='*' -C "$clone" update-index -q --refresh || : # else unchanged files are written, and `make` sees it
    git -c safe.directory='*' -C "$clone" reset -q --hard FETCH_HEAD
    git -c safe.directory='*' -C "$clone" clean -qfd
fi
chroot "$machine" chown -R "$user:$user" "$home/jauspy"

run() { # run PREFIX... -- COMMAND: in the clone, as the user
    chroot "$machine" su "$user" -c "cd ~/jauspy && PIP_CERT=${PIP_CERT:-} LC_ALL=C.UTF-8 $*"
}
case $network in
yes) run "$*" ;;
first)
    run make dev
    unshare --net sh -c 'ip link set lo up 2>/dev/null || :; "$@"' sh chroot "$machine" su "$user" -c "cd ~/jauspy && LC_ALL=C.UTF-8 $*"
    ;;
no) unshare --net sh -c 'ip link set lo up 2>/dev/null || :; "$@"' sh chroot "$machine" su "$user" -c "cd ~/jauspy && LC_ALL=C.UTF-8 $*" ;;
esac
