#!/usr/bin/env bash
# One scene from noon to midnight through every operator, as contact sheets in docs/pictures, and the page that shows them,
# docs/DISPLAY.md. Build first: ./run demo. VESPER_BIN names another folder of programs.
# The sheets are put together by oiiotool (Debian: openimageio-tools).
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
bin=${VESPER_BIN:-build/release/bin}
[[ -x $bin/vesper-render ]] || { echo "display_pictures: no $bin/vesper-render; build it with ./run demo" >&2; exit 1; }
command -v oiiotool >/dev/null || { echo "display_pictures: no oiiotool; install openimageio-tools" >&2; exit 1; }
tiles=$(mktemp -d)
trap 'rm -rf "$tiles"' EXIT
mkdir -p docs/pictures
page=$tiles/page.md

place=(--latitude 28.76 --longitude -17.88 --height 2400)
names=("noon" "sunset" "civil twilight" "nautical twilight" "astronomical twilight" "full Moon" "dark night")
times=(2026-08-14T13:10:00Z 2026-08-14T19:45:00Z 2026-08-14T20:06:00Z 2026-08-14T20:33:00Z 2026-08-14T21:02:00Z
  2026-08-28T01:30:00Z 2026-08-15T01:00:00Z)
operators=(visibility reinhard hable photographic false-color)

# render NAME TIME OPTIONS...: a picture that a page shows pixel by pixel.
render() {
  local name=$1 time=$2
  shift 2
  "$bin/vesper-render" --quiet --time "$time" "${place[@]}" --pixels-per-degree 37.8 --seed 1 "$@" -o "$tiles/$name.png"
}

quantities() {
  "$bin/vesper-report" --quiet --columns sun_altitude_deg,moon_altitude_deg,zenith_luminance_cd_m2,limiting_magnitude \
    --time "$1" "${place[@]}" | sed 's/.* = //' | paste -s -d ' '
}

cat docs/display_head.md >"$page"
{
  echo
  echo "## From noon to midnight"
  echo
  echo "La Palma (28.76 N, 17.88 W, 2400 m), the whole sky, 2026-08-14 and, with the full Moon, 2026-08-28. No option but"
  echo "\`--operator\` differs between the rows."
  echo
  echo "| | time (UTC) | Sun | Moon | zenith, cd/m2 | faintest star at the zenith, V |"
  echo "|---|---|---|---|---|---|"
} >>"$page"
for i in "${!names[@]}"; do
  read -r sun moon zenith limit < <(quantities "${times[$i]}")
  printf '| %s | %s | %.1f° | %.1f° | %.2g | %.1f |\n' "${names[$i]}" "${times[$i]%:00Z}" "$sun" "$moon" "$zenith" "$limit" >>"$page"
done

pictures=()
for operator in "${operators[@]}"; do
  for i in "${!names[@]}"; do
    render "$operator-$i" "${times[$i]}" --operator "$operator" --size 176x176
    pictures+=("$tiles/$operator-$i.png")
  done
done
oiiotool "${pictures[@]}" --mosaic:pad=2 "${#names[@]}x${#operators[@]}" -o docs/pictures/display_operators.png

# What the default makes of narrower fields.
render dusk "${times[2]}" --projection perspective --azimuth 275 --altitude 18 --fov 50 --size 480x360
render moonlight "${times[5]}" --projection perspective --azimuth 20 --altitude 25 --fov 60 --size 480x360
render milky-way "${times[6]}" --projection perspective --azimuth 215 --altitude 40 --fov 70 --size 480x360
read -r azimuth altitude < <("$bin/vesper-report" --quiet --columns moon_azimuth_deg,moon_altitude_deg --time "${times[5]}" \
  "${place[@]}" | sed 's/.* = //' | paste -s -d ' ')
render moon "${times[5]}" --projection perspective --azimuth "$azimuth" --altitude "$(awk -v h="$altitude" 'BEGIN { print h + 0.01 }')" \
  --fov 0.7 --size 480x360
oiiotool "$tiles"/{dusk,moonlight,milky-way,moon}.png --mosaic:pad=2 4x1 -o docs/pictures/display_fields.png

{
  echo
  echo "Rows: ${operators[*]}. Columns: as the table."
  echo
  echo "![from noon to midnight through every operator](pictures/display_operators.png)"
  echo
  echo "The default in narrower fields: civil twilight, moonlight, the Milky Way, the Moon."
  echo
  echo "![dusk, moonlight, Milky Way, Moon](pictures/display_fields.png)"
} >>"$page"
cp "$page" docs/DISPLAY.md
echo docs/DISPLAY.md
