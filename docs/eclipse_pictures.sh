#!/usr/bin/env bash
# Renders eclipses of the Moon and of the Sun as contact sheets into docs/pictures. Build first: ./run demo.
# The sheets are put together by oiiotool (Debian: openimageio-tools).
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
bin=build/release/bin
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

# sheet NAME BODY ROWSxCOLUMNS START STEP FOV TILE STOPS OPTIONS...: a body every STEP seconds from START, in the middle
# of a field of FOV degrees. STOPS are added to the exposure in totality.
sheet() {
  local name=$1 body=$2 grid=$3 start=$4 step=$5 fov=$6 tile=$7 stops=$8
  shift 8
  local count=$((${grid%x*} * ${grid#*x})) i time azimuth altitude umbral obscuration exposure pictures=()
  for ((i = 0; i < count; ++i)); do
    time=$(date -u -d "@$(($(date -u -d "$start" +%s) + i * step))" +%Y-%m-%dT%H:%M:%SZ)
    read -r azimuth altitude umbral obscuration < <(quantities \
      "${body}_azimuth_deg,${body}_altitude_deg,moon_umbral_magnitude,sun_obscuration" --time "$time" "$@")
    # Where the air shows it (Saemundsson's formula, by which the picture need only be centred).
    altitude=$(awk -v h="$altitude" 'BEGIN { x = (h + 10.3 / (h + 5.11)) * atan2(0, -1) / 180
                                             print h + 1.02 / 60 * cos(x) / sin(x) }')
    exposure=$(awk -v u="$umbral" -v o="$obscuration" -v s="$stops" 'BEGIN { print (u >= 1 || o >= 1) ? s : 0 }')
    pictures+=("$tiles/$name-$i.png")
    "$bin/vesper-render" --quiet --time "$time" "$@" --projection perspective --azimuth "$azimuth" \
      --altitude "$altitude" --fov "$fov" --size "${tile}x$tile" --seed 1 --exposure "$exposure" -o "${pictures[-1]}"
  done
  oiiotool "${pictures[@]}" --mosaic "$grid" -o "docs/pictures/$name.png"
  echo "docs/pictures/$name.png"
}

# The examples of Mueller, Engel and Doellner 2012: every quarter of an hour.
sheet lunar_eclipse_2011 moon 6x3 2011-06-15T18:15:00Z 900 0.8 200 3 --latitude 12.87 --longitude 74.88
sheet lunar_eclipse_2010 moon 6x3 2010-12-21T06:15:00Z 900 0.8 200 3 --latitude 40.71 --longitude -74.01
# Burgos, every eleven minutes until sunset, and totality with its landscape of light.
sheet solar_eclipse_2026 sun 5x2 2026-08-12T17:45:20Z 660 0.9 240 -3 --latitude 42.34 --longitude -3.70 --height 860
"$bin/vesper-render" --quiet --time 2026-08-12T18:29:20Z --latitude 42.34 --longitude -3.70 --height 860 --seed 1 \
  --projection perspective --azimuth 282 --altitude 20 --fov 60 --size 1200x600 --exposure -1.5 -o docs/pictures/totality_2026.png
echo docs/pictures/totality_2026.png
