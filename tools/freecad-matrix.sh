#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# All tests on three versions of FreeCAD, on one machine of the Debian family, as root.  What needs no FreeCAD runs once.
#
#   0.20  as Debian bookworm has it   (Qt 5)
#   1.0   as Debian trixie has it     (Qt 5)
#   1.1   as Debian forky has it      (Qt 6); forky is not released yet and moves on: what it gives is tested and named
#
# The version that the machine itself has is used where it is, each other one in a chroot of its own that this script
# builds (about 2.5 GB each).  What cannot be built is a failure, never a skip.
#
#   tools/freecad-matrix.sh test [VERSION...]              build what is missing, then all tests (default: all versions)
#   tools/freecad-matrix.sh install [VERSION...]           only build
#   tools/freecad-matrix.sh exec VERSION -- COMMAND...     run in the current folder, with that version on the path
#   tools/freecad-matrix.sh status                         what is there
#   tools/freecad-matrix.sh remove VERSION                 delete a chroot
#
# Environment: SENS_MATRIX_ROOT, where the chroots are; SENS_MATRIX_MIRROR, the Debian mirror (default: that of this
# machine's apt); SENS_JOBS, how many versions are tested side by side (default: one a core).  A command sees its
# current folder, /tmp and, below both, everything at the same path; its mounts and all its processes end with it.
set -euo pipefail

SELF=$(realpath "${BASH_SOURCE[0]}")
PROJECT=$(dirname "$(dirname "$SELF")")
ROOTS=${SENS_MATRIX_ROOT:-/var/lib/sens-freecad}
VERSIONS=(0.20 1.0 1.1)
READY=.sens-matrix-ready
PACKAGES=(freecad xvfb xauth libgl1-mesa-dri git python3-git python3-pivy python3-pytest python3-hypothesis
          python3-numpy python3-scipy python3-matplotlib)
SYSTEM_PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin

say() { printf 'freecad-matrix: %s\n' "$*" >&2; }
die() { say "$*"; exit 1; }
have() { command -v "$1" > /dev/null 2>&1; }
known() { [[ " ${VERSIONS[*]} " == *" $1 "* ]] || die "no such version: $1 (there are ${VERSIONS[*]})"; }

packages_of() { # what a version needs beyond PACKAGES: Qt 6 shows no arrow and no tick without its SVG plug-in
    echo "${PACKAGES[*]}$([ "$1" = 1.1 ] && echo " qt6-svg-plugins")"
}

suite_of() {
    case $1 in
        0.20) echo bookworm ;;
        1.0) echo trixie ;;
        1.1) echo forky ;;
    esac
}

# not freecadcmd --version: 0.20 hands its first option to Python's own parser and crashes
REPORT='import FreeCAD, sys; print("version", ".".join(FreeCAD.Version()[:3]), "Python", sys.version.split()[0])'

native_version() { # "0.20.2" of the machine's own FreeCAD, or nothing
    have freecadcmd || return 0
    timeout 120 freecadcmd -c "$REPORT" 2> /dev/null < /dev/null | sed -n 's/^version \([0-9.]*\) Python.*/\1/p' || true
}

root_of() { # "/" for the machine's own version
    if [[ ${NATIVE-} == "$1".* ]]; then echo /; else echo "$ROOTS/freecad-$1"; fi
}

# ---------------------------------------------------------------- building

mirror() {
    local site=${SENS_MATRIX_MIRROR:-}
    # shellcheck disable=SC2016
    [ -n "$site" ] || site=$(apt-get indextargets --format '$(SITE)' | grep -E '/debian/?$' | sort -u | head -n 1) || true
    [ -n "$site" ] || die "no Debian mirror in apt's sources; set SENS_MATRIX_MIRROR"
    echo "${site%/}"
}

require() { # what a chroot needs, or a loud end
    [ "$(id -u)" = 0 ] || die "chroots with other versions of FreeCAD need root; run this as root (sudo -E $0 ...)"
    have unshare || die "unshare is missing (package util-linux)"
    have chroot || die "chroot is missing (package coreutils)"
    have debootstrap && return 0
    have apt-get || die "debootstrap is missing and there is no apt-get to install it; FreeCAD ${VERSIONS[*]} cannot be had"
    apt-get -q update >&2 || say "apt-get update failed; trying with the lists that are there"
    DEBIAN_FRONTEND=noninteractive apt-get -q -y install --no-install-recommends debootstrap >&2 ||
        die "debootstrap is missing and cannot be installed; FreeCAD ${VERSIONS[*]} cannot be had"
}

build() { # VERSION
    local version=$1 suite root site
    suite=$(suite_of "$version")
    root=$(root_of "$version")
    [ "$(cat "$root/$READY" 2> /dev/null)" != "$(packages_of "$version")" ] || return 0
    require
    site=$(mirror)
    if [ ! -e "$root/.debootstrapped" ]; then # absent, or cut off half way
        delete_root "$root"
        # a release has no script in an older debootstrap; that of sid fits every later one
        debootstrap --variant=minbase "$suite" "$root" "$site" /usr/share/debootstrap/scripts/sid ||
            die "debootstrap of $suite failed: FreeCAD $version is not tested"
        touch "$root/.debootstrapped"
    fi
    cp -L /etc/resolv.conf "$root/etc/resolv.conf"
    printf 'deb %s %s main\n' "$site" "$suite" > "$root/etc/apt/sources.list"
    cat > "$root/etc/apt/apt.conf.d/90sens-matrix" << 'APT'
APT::Install-Recommends "false";
APT::Install-Suggests "false";
Acquire::Languages "none";
Acquire::Check-Valid-Until "false";
APT
    cat > "$root/etc/dpkg/dpkg.cfg.d/90sens-matrix" << 'DPKG'
force-unsafe-io
path-exclude=/usr/share/doc/*
path-exclude=/usr/share/man/*
path-exclude=/usr/share/locale/*
DPKG
    printf '#!/bin/sh\nexit 101\n' > "$root/usr/sbin/policy-rc.d" # start no services
    chmod +x "$root/usr/sbin/policy-rc.d"
    inside "$root" apt-get -q update || die "apt-get update in $suite failed: FreeCAD $version is not tested"
    # shellcheck disable=SC2046
    inside "$root" env DEBIAN_FRONTEND=noninteractive apt-get -q -y install $(packages_of "$version") ||
        die "FreeCAD cannot be installed from $suite: FreeCAD $version is not tested"
    inside "$root" apt-get clean
    packages_of "$version" > "$root/$READY"
}

install() {
    local version got
    for version in "$@"; do
        if [ "$(root_of "$version")" = / ]; then
            "$PROJECT/tools/prepare.sh" >&2
        else
            mkdir -p "$ROOTS"
            ( # one build at a time
                exec 9> "$ROOTS/.lock"
                flock 9
                build "$version" 9>&- >&2
            )
        fi
        got=$(inside "$(root_of "$version")" freecadcmd -c "$REPORT" 2> /dev/null | grep '^version ') ||
            die "FreeCAD $version does not start"
        say "FreeCAD $version is $got"
        [[ $got == "version $version".* ]] ||
            say "NOTE: $(suite_of "$version") has moved on from $version; what it gives is tested"
    done
}

delete_root() {
    [ -d "$1" ] || return 0
    ! grep -q " $1/" /proc/mounts || die "something is mounted below $1; unmount it first"
    rm -rf --one-file-system "$1"
}

# ---------------------------------------------------------------- running

inside() { # ROOT COMMAND...   in the current folder, in mount and process namespaces of its own
    local root=$1 environment
    shift
    environment=(env -u PYTHONPATH -u PYTHONHOME -u VIRTUAL_ENV -u LD_LIBRARY_PATH
                 "PATH=$SYSTEM_PATH" HOME=/root LANG=C.UTF-8 LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
                 QTWEBENGINE_DISABLE_SANDBOX=1 LIBGL_ALWAYS_SOFTWARE=1)
    if [ "$root" = / ]; then
        "${environment[@]}" "$@"
        return
    fi
    [ -x "$root/bin/sh" ] || die "nothing is installed in $root: $0 install"
    # The shell stays as process 1: Xvfb sends no ready signal to a parent that is process 1.
    # shellcheck disable=SC2016
    unshare --mount --pid --fork --kill-child=KILL --propagation private -- bash -c '
        set -e
        root=$1 here=$2
        shift 2
        [ -e "$root/proc/self" ] || mount -t proc proc "$root/proc"
        mount --rbind /dev "$root/dev"
        mount --bind /tmp "$root/tmp" # also the X locks and sockets
        case $here/ in
            / | // | /tmp/* | /bin/* | /dev/* | /etc/* | /lib/* | /proc/* | /sbin/* | /sys/* | /usr/*) ;; # there already
            *)
                mkdir -p "$root$here"
                mount --rbind "$here" "$root$here"
                ;;
        esac
        set +e
        chroot "$root" /bin/sh -c "cd \"\$1\" 2> /dev/null || cd /; shift; exec \"\$@\"" sh "$here" "$@"
        exit $?
    ' bash "$root" "$PWD" "${environment[@]}" "$@"
}

tests_in_chroot() { # VERSION: the tiers that `make` runs on the machine's own FreeCAD, with that version's own Python
    local root status=0
    root=$(root_of "$1")
    # shellcheck disable=SC2046
    inside "$root" python3 -m pytest -p no:cacheprovider --disable-warnings $(cat tests/portable.txt) || status=1
    inside "$root" python3 tests/run_in_freecad.py -p no:cacheprovider --disable-warnings tests/document || status=1
    inside "$root" python3 tests/run_in_freecad.py --gui -p no:cacheprovider --disable-warnings tests/gui || status=1
    inside "$root" python3 -m pytest -p no:cacheprovider --disable-warnings tests/install || status=1
    return "$status"
}

run_job() { # plain, or a VERSION
    if [ "$1" = plain ]; then
        make --no-print-directory -k test-style test-plain WORKERS=0
    elif [ "$(root_of "$1")" = / ]; then
        make --no-print-directory -k test-portable test-freecad test-window test-install
    else
        tests_in_chroot "$1"
    fi
}

test_one() { # JOB LOG: run it; its lines appear with its name in front
    local job=$1 log=$2 began=$SECONDS status
    set +e # a failure is told, and the other jobs still run
    ( run_job "$job" ) < /dev/null 2>&1 | tee "$log" | sed -u "s/^/[$job] /"
    status=${PIPESTATUS[0]}
    set -e
    if [ "$status" = 0 ] && grep -q '^Traceback' "$log"; then
        say "an exception went to the log of $job"
        status=1
    fi
    say "$job: $([ "$status" = 0 ] && echo passed || echo FAILED) after $((SECONDS - began)) s"
    [ "$status" = 0 ] || touch "$log.failed"
}

closing_lines() { # LOG: "1385 passed, 3 deselected in 130.2s" of every tier
    grep -hoE '[0-9]+ (passed|failed|error|errors|skipped|deselected)\b.* in [0-9.]+s.*' "$1" | tr -d '=' || true
}

test_all() {
    local logs=build/matrix job failed=() versions=("$@") lanes=${SENS_JOBS:-$(nproc)} began=$SECONDS
    cd "$PROJECT"
    rm -rf "$logs"
    mkdir -p "$logs"
    make --no-print-directory venv # here, and not by two jobs at a time
    install "${versions[@]}"
    say "everything is built after $((SECONDS - began)) s; tests: $lanes at a time"
    began=$SECONDS
    [ "$lanes" -gt 1 ] && export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
    for job in plain "${versions[@]}"; do
        while [ "$(jobs -rp | wc -l)" -ge "$lanes" ]; do wait -n || true; done
        test_one "$job" "$logs/$job.log" &
    done
    wait
    say "summary"
    for job in plain "${versions[@]}"; do
        closing_lines "$logs/$job.log" | sed "s/^/$job: /"
        [ ! -e "$logs/$job.log.failed" ] || failed+=("$job")
    done
    # one closing line in pytest's own form over all tiers and versions
    cat "$logs"/*.log | closing_lines - | awk -v seconds=$((SECONDS - began)) '
        { sub(/ in .*/, ""); n = split($0, part, /, /); for (i = 1; i <= n; i++) { split(part[i], w, " "); sum[w[2]] += w[1] } }
        END {
            m = split("failed passed skipped deselected error errors", order, " ")
            for (i = 1; i <= m; i++) if (sum[order[i]]) line = line (line ? ", " : "") sum[order[i]] " " order[i]
            printf "===== %s in %.2fs =====\n", line, seconds
        }'
    [ ${#failed[@]} -eq 0 ] || die "FAILED: ${failed[*]}"
    say "passed: plain, and FreeCAD ${versions[*]}"
}

# ---------------------------------------------------------------- main

command=${1:-help}
[ $# -eq 0 ] || shift
case $command in
    test | install)
        [ $# -gt 0 ] || set -- "${VERSIONS[@]}"
        for version in "$@"; do known "$version"; done
        "$PROJECT/tools/prepare.sh" >&2
        NATIVE=$(native_version)
        say "this machine's own FreeCAD is ${NATIVE:-none}"
        if [ "$command" = test ]; then test_all "$@"; else install "$@"; fi
        ;;
    exec)
        [ $# -ge 3 ] && [ "$2" = -- ] || die "exec VERSION -- COMMAND..."
        known "$1"
        NATIVE=$(native_version)
        root=$(root_of "$1")
        shift 2
        inside "$root" "$@"
        ;;
    status)
        NATIVE=$(native_version)
        for version in "${VERSIONS[@]}"; do
            root=$(root_of "$version")
            if [ "$root" = / ]; then
                echo "$version  $NATIVE, this machine's own"
            elif [ -e "$root/$READY" ]; then
                # shellcheck disable=SC2016
                echo "$version  $(chroot "$root" dpkg-query -W -f '${Version}' freecad) in $root"
            else
                echo "$version  not there"
            fi
        done
        ;;
    remove)
        known "${1:-}"
        NATIVE=
        delete_root "$(root_of "$1")"
        ;;
    help | -h | --help) sed -n '3,/^set/s/^# \{0,1\}//p' "$SELF" ;;
    *) die "unknown command: $command (try help)" ;;
esac
