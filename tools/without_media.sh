#!/bin/sh
# without_media.sh COMMAND...: runs a command that finds no GL library, no ffmpeg and no GStreamer, as on a bare machine.
# They are removed in overlays that only this command sees. An ordinary user gets these in a user namespace; where the system
# does not permit that, the script says so and exits with 77.
set -eu
PATH=$PATH:/usr/sbin:/sbin # ldconfig
if [ "${1-}" = --inside ]; then
    user=$2 group=$3
    shift 3
    scratch=$(mktemp -d)
    mount -t tmpfs tmpfs "$scratch"
    attributes= # of overlays: as an ordinary user, in the namespace `user`
    [ "$user" = 0 ] || attributes=,userxattr
    hide() { # hide FOLDER NAME...: FOLDER without these files
        folder=$1 layer=$scratch/$(basename "$1")
        shift
        mkdir -p "$layer/upper" "$layer/work"
        mount -t overlay overlay -o "lowerdir=$folder,upperdir=$layer/upper,workdir=$layer/work$attributes" "$folder"
        (cd "$folder" && rm -f "$@")
    }
    for folder in $(ldconfig -p | sed -n 's/.*=> \(.*\)\/lib\(EGL\|OSMesa\|GL\|GLX\|OpenGL\)[._].*/\1/p' | xargs -r -n 1 realpath | sort -u); do
        hide "$folder" $(cd "$folder" && ls | grep -E '^lib(EGL|OSMesa|GL|GLX|OpenGL)[._]')
    done
    programs='ffmpeg ffprobe ffplay gst-launch-1.0 gst-inspect-1.0'
    # shellcheck disable=SC2086
    for folder in $(which $programs | xargs -r -n 1 realpath | xargs -r -n 1 dirname | sort -u); do hide "$folder" $programs; done
    ldconfig -C "$scratch/ld.so.cache" 2>/dev/null
    mount --bind "$scratch/ld.so.cache" /etc/ld.so.cache
    [ "$user" = 0 ] || exec unshare --user --map-user="$user" --map-group="$group" "$@" # the same user as outside
    exec "$@"
fi
new=
[ "$(id -u)" = 0 ] || new='--user --map-root-user'
# shellcheck disable=SC2086
unshare $new --mount true 2>/dev/null || {
    echo "without_media: this system permits no mount namespace (it takes root or user namespaces): not run" >&2
    exit 77
}
# shellcheck disable=SC2086
exec unshare $new --mount --propagation private "$0" --inside "$(id -u)" "$(id -g)" "$@"
