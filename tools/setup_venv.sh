#!/bin/sh
# Usage: setup_venv.sh DIR user|developer
# Makes the virtual environment DIR and installs jauspy into it, editable, with all extras; a developer
# also gets the checkers and a wheelhouse, so that `make test` works without a network afterwards.
set -eu
venv=$1
who=$2
python=${PYTHON:-python3}

say() { printf '%s\n' "$*" >&2; }

"$python" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || {
    say "jauspy needs Python 3.11 or newer, and '$python' is not; name another one, as in: make PYTHON=python3.12"
    exit 1
}

# Debian and Ubuntu ship venv without pip unless this package is there.
if ! "$python" -c 'import ensurepip' 2>/dev/null; then
    if [ "$(id -u)" = 0 ]; then as_root=; else as_root='sudo -n'; fi
    say "installing Debian's python3-venv, which '$python -m venv' needs"
    { $as_root apt-get update -q && $as_root apt-get install -qy --no-install-recommends python3-venv; } >&2 || {
        say "could not install it; run: sudo apt-get install python3-venv"
        exit 1
    }
fi

[ -x "$venv/bin/python" ] || "$python" -m venv "$venv"
pip() { "$venv/bin/python" -m pip --disable-pip-version-check -q "$@"; }

case $who in
user)
    say "installing jauspy and its extras into $venv (once; a minute or two)"
    pip install --upgrade 'pip>=25.1'
    pip install -e '.[all]'
    ;;
developer)
    say "installing the developers' tools into $venv (once)"
    pip install --group dev
    "$venv/bin/python" tools/wheel_test.py --download
    ;;
*)
    say "the second argument is 'user' or 'developer', not '$who'"
    exit 2
    ;;
esac
