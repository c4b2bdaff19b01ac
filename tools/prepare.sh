#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Install what `make demo` and `make test` need and this machine lacks: FreeCAD, a virtual display, Python's venv.
# Debian and its kin: by apt-get, as root or with sudo.  Elsewhere: say what is missing.  A second run only looks.
set -euo pipefail

have() { command -v "$1" >/dev/null 2>&1; }
missing=()
have python3 || missing+=(python3)
system=/usr/bin/python3  # FreeCAD's: another python3 may come first on the path
[ -x "$system" ] || system=python3
have freecadcmd || have FreeCADCmd || missing+=(freecad)
have xvfb-run || missing+=(xvfb)
have xauth || missing+=(xauth)
python3 -c 'import ensurepip, venv' 2>/dev/null || missing+=(python3-venv)
"$system" -c 'import numpy' 2>/dev/null || missing+=(python3-numpy)
"$system" -c 'import matplotlib' 2>/dev/null || missing+=(python3-matplotlib)
if have dpkg-query; then
    for package in libgl1-mesa-dri python3-pivy; do  # software rendering; Coin for Python
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok' || missing+=("$package")
    done
fi
[ ${#missing[@]} -eq 0 ] && exit 0

echo "missing: ${missing[*]}"
if ! have apt-get; then
    echo "Install these with your system's package manager, then call make again." >&2
    exit 1
fi
run=()
if [ "$(id -u)" -ne 0 ]; then
    if ! have sudo; then
        echo "Become root, or install sudo, then call make again." >&2
        exit 1
    fi
    run=(sudo)
fi
"${run[@]}" apt-get update -q
"${run[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
