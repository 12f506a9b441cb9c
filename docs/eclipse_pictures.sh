#!/usr/bin/env bash
# Renders the Moon's phases and eclipses of Moon and Sun as contact sheets into docs/pictures, as a camera has them. Build
# first: ./run demo. VESPER_BIN names another folder of programs.
# The sheets are put together by oiiotool (Debian: openimageio-tools).
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
bin=${VESPER_BIN:-build/release/bin}
[[ -x $bin/vesper-render ]] || { echo "eclipse_pictures: no $bin/vesper-render; build it with ./run demo" >&2; exit 1; }
command -v oiiotool >/dev/null || { echo "eclipse_pictures: no oiiotool; install openimageio-tools" >&2; exit 1; }
tiles=$(mktemp -d)
trap 'rm -rf "$tiles"' EXIT
mkdir -p docs/pictures

# quantities COLUMNS OPTIONS...: their values on one line.
quantities() {
  local columns=$1
  shift
  "$bin/vesper-report" --quiet --columns "$columns" "$@" | sed 's/.* = //' | paste -s -d ' '
}

# aim BODY OPTIONS...: options of a view with the body in the middle, where the air shows it (Saemundsson's formula, by
# which the picture need only be centred).
aim() {
  local body=$1 azimuth altitude
  shift
  read -r azimuth altitude < <(quantities "${body}_azimuth_deg,${body}_altitude_deg" "$@")
  awk -v a="$azimuth" -v h="$altitude" 'BEGIN {
    x = (h + 10.3 / (h + 5.11)) * atan2(0, -1) / 180
    print "--projection perspective --azimuth", a, "--altitude", h + 1.02 / 60 * cos(x) / sin(x) }'
}

# stops OPTIONS...: of --exposure over --ev 15 (the Sun's disc asks for more than --ev has), as a photographer sets them:
# the brightest of the picture, or its red, is just white. Of the corona, whose foot is that, two stops more are shown.
stops() {
  local covered=0
  [[ $1 == corona ]] && covered=2
  shift
  "$bin/vesper-render" --quiet "$@" --size 100x100 -o "$tiles/meter.exr"
  oiiotool --stats "$tiles/meter.exr" | awk -v c="$covered" '/Stats Max/ {
    red = 3.24 * $3 - 1.54 * $4 - 0.5 * $5
    print 15 - log((red > $4 ? red : $4) / 1.2) / log(2) + c }'
}

# sheet NAME BODY ROWSxCOLUMNS START STEP FOV TILE OPTIONS...: a body every STEP seconds from START, in the middle of a
# field of FOV degrees.
sheet() {
  local name=$1 body=$2 grid=$3 start=$4 step=$5 fov=$6 tile=$7
  shift 7
  local count=$((${grid%x*} * ${grid#*x})) i time view shown pictures=()
  for ((i = 0; i < count; ++i)); do
    time=$(date -u -d "@$(($(date -u -d "$start" +%s) + i * step))" +%Y-%m-%dT%H:%M:%SZ)
    read -r -a view < <(aim "$body" --time "$time" "$@")
    view+=(--time "$time" "$@" --fov "$fov" --seed 1)
    shown=$body
    [[ $(quantities sun_obscuration --time "$time" "$@") == 1 ]] && shown=corona
    pictures+=("$tiles/$name-$i.png")
    "$bin/vesper-render" --quiet "${view[@]}" --size "${tile}x$tile" --operator photographic --ev 15 \
      --exposure "$(stops "$shown" "${view[@]}")" -o "${pictures[-1]}"
  done
  oiiotool "${pictures[@]}" --mosaic "$grid" -o "docs/pictures/$name.png"
  echo "docs/pictures/$name.png"
}

# The examples of Mueller, Engel and Doellner 2012: every quarter of an hour.
sheet lunar_eclipse_2011 moon 6x3 2011-06-15T18:15:00Z 900 0.8 200 --latitude 12.87 --longitude 74.88
sheet lunar_eclipse_2010 moon 6x3 2010-12-21T06:15:00Z 900 0.8 200 --latitude 40.71 --longitude -74.01
# Burgos, every eleven minutes until sunset, and totality with its landscape of light.
burgos=(--latitude 42.34 --longitude -3.70 --height 860)
sheet solar_eclipse_2026 sun 5x2 2026-08-12T17:45:20Z 660 0.9 240 "${burgos[@]}"
"$bin/vesper-render" --quiet --time 2026-08-12T18:29:20Z "${burgos[@]}" --seed 1 --projection perspective --azimuth 282 \
  --altitude 20 --fov 60 --size 1200x600 --operator photographic --ev 5 -o docs/pictures/totality_2026.png
echo docs/pictures/totality_2026.png
