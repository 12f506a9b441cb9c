#!/usr/bin/env bash
# Writes docs/SKY_TABLES.md and its pictures: the tables of the sky beside the reference transport, and what other sizes
# and mappings would give. Needs oiiotool (Debian: openimageio-tools) and some ten minutes on two cores. Build the
# release preset first, benchmarks included: cmake --preset release && ninja -C build/release
# SIZE (40) is the width of a picture in pixels before it is enlarged, PATHS (400) what each pixel of the reference gets.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
bin=${BIN:-build/release/bin}
report=$bin/vesper-report
pictures=docs/pictures/sky_tables
for needed in "$report" "$bin/bench_sky_tables" oiiotool; do
  command -v "$needed" >/dev/null || { echo "sky_tables: no $needed; see the head of this script" >&2; exit 1; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$pictures"
altitudes=(45 10 1 -2 -4 -6 -8 -12 -16)

# field FILE ROW NAME: a cell of a CSV file by its row (from 1) and the name of its column.
field() {
  awk -F, -v row="$2" -v name="$3" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) column = i; next }
    NR == row + 1 { print $column }' "$1"
}
places() { echo altitude_deg,azimuth_deg,sun_altitude_deg; printf '90,0,%s\n' "$@"; }
sky() { "$report" sky --medium clear "$@"; }

places "${altitudes[@]}" >"$work/zenith.csv"
sky --directions "$work/zenith.csv" --illuminance -o "$work/tables.csv"
sky --reference --directions "$work/zenith.csv" --illuminance --relative-error 0.01 --timings -o "$work/reference.csv"

for row in $(seq "${#altitudes[@]}"); do
  altitude=${altitudes[row - 1]}
  echo "pictures at $altitude" >&2
  paths=${PATHS:-400}
  if ((altitude < -8)); then paths=$((4 * paths)); fi
  size=${SIZE:-40}
  sky --sun-altitude "$altitude" --picture --size "${size}x$size" -o "$work/table.exr"
  sky --reference --sun-altitude "$altitude" --picture --size "${size}x$size" --most-paths "$paths" \
    -o "$work/reference.exr"
  # X, Y, Z to linear sRGB; what is as bright as the zenith comes out at 0.3, what is brighter is bent below 1.
  gain=$(awk -v luminance="$(field "$work/reference.csv" "$row" luminance_cd_m2)" 'BEGIN { print 0.43 / luminance }')
  for kind in table reference; do
    oiiotool "$work/$kind.exr" --ch X,Y,Z --mulc "$gain" \
      --ccmatrix:transpose=1 3.2406,-1.5372,-0.4986,-0.9689,1.8758,0.0415,0.0557,-0.2040,1.0570 \
      --clamp:min=0 --resize:filter=gaussian 160x160 --dup --addc 1 --div --colorconvert linear sRGB \
      --chnames R,G,B -d uint8 -o "$pictures/${kind}_$altitude.png"
  done
  # (table - reference) / reference of the luminance: black -20 %, grey none, white +20 %.
  oiiotool "$work/table.exr" --ch Y "$work/reference.exr" --ch Y --sub "$work/reference.exr" --ch Y --div \
    --mulc 2.5 --addc 0.5 --clamp:min=0:max=1 --resize:filter=box 160x160 -d uint8 -o "$pictures/difference_$altitude.png"
done

# Illuminance: airless altitudes for the tables and the reference; the fit's, from 0 up, are apparent.
mapfile -t curve < <(seq -18 90)
places "${curve[@]}" >"$work/curve_places.csv"
sky --directions "$work/curve_places.csv" --illuminance -o "$work/curve.csv"
awk -F, 'NR > 1 { print $1 - ($1 >= 0 ? 1 / (60 * tan_deg($1 + 7.31 / ($1 + 4.4))) : 0) "," $2 }
  function tan_deg(d) { d *= 3.14159265358979 / 180; return sin(d) / cos(d) }' \
  tests/data/atmosphere/illuminance_clear_sky.csv >"$work/fit.csv"
column() { awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) column = i; next }
  { print $column }' "$1"; }
paste -d, <(printf '%s\n' "${curve[@]}") <(column "$work/curve.csv" horizontal_illuminance_lux) >"$work/line.csv"
paste -d, <(printf '%s\n' "${altitudes[@]}") <(column "$work/reference.csv" horizontal_illuminance_lux) \
  >"$work/points.csv"
awk -F, -v line="$work/line.csv" -v points="$work/points.csv" -v fit="$work/fit.csv" '
  function px(altitude) { return 60 + (altitude + 18) * 560 / 108 }
  function py(lux) { return 20 + (6 - log(lux) / log(10)) * 340 / 11 }
  BEGIN {
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"640\" height=\"410\" font-family=\"sans-serif\" font-size=\"12\">"
    print "<rect width=\"640\" height=\"410\" fill=\"white\"/>"
    for (e = -5; e <= 6; ++e) {
      printf "<path d=\"M60 %.1fH620\" stroke=\"#ddd\"/><text x=\"52\" y=\"%.1f\" text-anchor=\"end\">1e%d</text>\n", py(10 ^ e), py(10 ^ e) + 4, e
    }
    for (a = -18; a <= 90; a += 18) {
      printf "<path d=\"M%.1f 20V360\" stroke=\"#ddd\"/><text x=\"%.1f\" y=\"376\" text-anchor=\"middle\">%d</text>\n", px(a), px(a), a
    }
    printf "<path fill=\"none\" stroke=\"#1f5fbf\" stroke-width=\"1.5\" d=\""
    command = "M"
    while ((getline < line) > 0) { printf "%s%.1f %.1f", command, px($1), py($2); command = "L" }
    print "\"/>"
    while ((getline < fit) > 0) printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" fill=\"none\" stroke=\"#c04000\"/>\n", px($1), py($2)
    while ((getline < points) > 0) printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"2\" fill=\"black\"/>\n", px($1), py($2)
    print "<text x=\"340\" y=\"398\" text-anchor=\"middle\">altitude of the Sun, degrees; illuminance of level ground, lux</text>"
    print "<text x=\"400\" y=\"250\" fill=\"#1f5fbf\">tables</text><text x=\"400\" y=\"268\">&#8226; reference</text>"
    print "<text x=\"400\" y=\"286\" fill=\"#c04000\">&#9675; fit to measured light</text>\n</svg>"
  }' >"$pictures/illuminance.svg"

column_rows() {
  local row altitude
  for row in $(seq "${#altitudes[@]}"); do
    altitude=${altitudes[row - 1]}
    printf '| %s ' "$altitude"
    for kind in table reference difference; do
      printf '| ![](pictures/sky_tables/%s_%s.png) ' "$kind" "$altitude"
    done
    awk -v t="$(field "$work/tables.csv" "$row" luminance_cd_m2)" \
      -v r="$(field "$work/reference.csv" "$row" luminance_cd_m2)" \
      -v tl="$(field "$work/tables.csv" "$row" horizontal_illuminance_lux)" \
      -v rl="$(field "$work/reference.csv" "$row" horizontal_illuminance_lux)" \
      -v seconds="$(field "$work/reference.csv" "$row" seconds)" 'BEGIN {
        printf "| %.4g | %.4g | %+.1f %% | %.4g | %.4g | %+.1f %% | %.1f |\n", t, r, 100 * (t / r - 1), tl, rl,
          100 * (tl / rl - 1), seconds }'
  done
}

fit_rows() {
  { echo altitude_deg,azimuth_deg,sun_altitude_deg; awk -F, '{ print "90,0," $1 }' "$work/fit.csv"; } \
    >"$work/fit_places.csv"
  sky --directions "$work/fit_places.csv" --illuminance -o "$work/fit_tables.csv"
  paste -d, "$work/fit.csv" <(column "$work/fit_tables.csv" horizontal_illuminance_lux) |
    awk -F, '{ printf "| %.2f | %.4g | %.4g | %.2f |\n", $1, $3, $2, $3 / $2 }'
}

{
  cat <<'TEXT'
# Tables of the sky

How the sky of `clear` looks from the tables that are drawn (`vesper/atmosphere/sky_tables.hpp`) and from the reference
transport that judges them. Made by `docs/sky_tables.sh`. What is held by tests stands in [ACCURACY.md](ACCURACY.md), sky
tables, sky steps and spectral rule: luminance over the sky, chromaticity, Sun and Moon, from the ground to 11 km.

## Side by side
The whole sky: zenith in the middle, the Sun to the south (below), east on the left. Both pictures are as bright as the
reference's zenith. The difference is that of the luminance over the reference's: black is -20 %, grey none, white
+20 %; most of it is the reference's grain. Zenith luminance in cd/m2 and illuminance of level ground in lux by tables and
reference (within 1 %), and the seconds that the reference took for these two.

| Sun, degrees | tables | reference | difference | zenith, tables | reference | | lux, tables | reference | | s |
|---|---|---|---|---|---|---|---|---|---|---|
TEXT
  column_rows
  cat <<'TEXT'

## Illuminance
Level ground under `clear` by the tables, against the fit of US Naval Observatory Circular 171 to another day's air
(`tests/data/atmosphere/illuminance_clear_sky.csv`) at the same airless altitudes.

![Illuminance from 90 to -18 degrees](pictures/sky_tables/illuminance.svg)

| Sun, degrees | tables, lux | fit, lux | ratio |
|---|---|---|---|
TEXT
  fit_rows
  cat <<'TEXT'

The tables below come from `bench_sky_tables`. Errors there are those against the light field that all tables are filled
from, so that they tell of tables alone; at 60 km and below -6 degrees the Earth's shadow ends in a sharp edge in air
that sends less than 1e-8 of the light, which no table of this size resolves.

TEXT
  "$bin/bench_sky_tables"
} >"$work/page.md"
chmod 644 "$work/page.md"
mv "$work/page.md" docs/SKY_TABLES.md
echo docs/SKY_TABLES.md
