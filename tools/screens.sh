#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# A picture of every panel, in build/screens: on each version of FreeCAD that tools/freecad-matrix.sh has installed, with
# FreeCAD's own light and dark theme, on small and large screens and at 200 %.  A panel that is cut is a failure.
#
#   tools/screens.sh [PYTEST-ARGUMENTS]
set -uo pipefail
cd "$(dirname "$(realpath "$0")")/.."
status=0
mkdir -p build
tools/freecad-matrix.sh status > build/versions.txt
while read -r version words; do
    [[ $words != *"not there"* ]] || continue
    # the machine's own FreeCAD may lack pytest, which .venv has; a chroot has its own
    python=python3
    [[ $words != *"own"* ]] || python=.venv/bin/python
    for look in "1366x768 light 1" "1600x1000 dark 1" "2880x1800 light 2"; do
        read -r size theme scale <<< "$look"
        settings=(env "SENS_SCREEN=$size" "SENS_THEME=$theme")
        [ "$scale" = 1 ] || settings+=("QT_SCALE_FACTOR=$scale")
        tools/freecad-matrix.sh exec "$version" -- "${settings[@]}" \
            "$python" tests/run_in_freecad.py --gui -q -p no:cacheprovider tests/gui/test_layout.py "$@" < /dev/null || status=1
    done
done < build/versions.txt
ls build/screens
exit "$status"
