#!/usr/bin/env bash
# Renders the pictures of the documentation into docs/pictures. Build first: ./run demo
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
render=build/release/bin/vesper-render
[[ -x $render ]] || { echo "render_pictures: no $render; build it with ./run demo" >&2; exit 1; }
mkdir -p docs/pictures

# dusk NAME OPTIONS...: Madrid, the Sun 4 degrees below the horizon.
dusk() {
  local name=$1
  shift
  "$render" --quiet --time 2026-08-12T19:34:00Z --latitude 40.4 --longitude -3.7 --height 700 --seed 1 "$@" \
    -o "docs/pictures/$name.png"
  echo "docs/pictures/$name.png"
}

# picture NAME OPTIONS...: a winter evening at Greenwich, Orion on the meridian.
picture() {
  local name=$1
  shift
  "$render" --quiet --time 2026-01-15T22:00:00Z --latitude 51.4769 --longitude 0 --height 47 --seed 1 "$@" \
    -o "docs/pictures/$name.png"
  echo "docs/pictures/$name.png"
}

# milky_way NAME TIME OPTIONS...: a new Moon on the Teide at solar minimum, as a camera has it.
milky_way() {
  local name=$1 time=$2
  shift 2
  "$render" --quiet --time "$time" --latitude 28.3 --longitude -16.5 --height 2400 --seed 1 --solar-flux 70 \
    --operator photographic "$@" \
    -o "docs/pictures/$name.png"
  echo "docs/pictures/$name.png"
}

# The whole sky as the eye has it: zenith in the middle, south below, east on the left; two fields as a camera has them.
picture tonight --projection fisheye --azimuth 180 --altitude 90 --fov 180 --size 1024x1024
picture orion --operator photographic --exposure -1 --projection perspective --azimuth 180 --altitude 36 --fov 32 --size 1200x800
picture plough --operator photographic --exposure -1 --projection perspective --azimuth 42 --altitude 37 --fov 40 --size 1200x800
"$render" --quiet --time 2026-03-18T21:00:00Z --latitude 28.3 --longitude -16.5 --height 2400 --seed 1 --projection perspective \
  --azimuth 270 --altitude 25 --fov 70 --size 1200x800 --solar-flux 80 --operator photographic -o docs/pictures/zodiacal.png
echo docs/pictures/zodiacal.png
dusk dusk --projection perspective --azimuth 285 --altitude 20 --fov 60 --size 1200x600
# The summer Milky Way over the south, its clouds in Sagittarius, and the winter one.
milky_way milky_way_summer 2026-07-14T23:30:00Z --size 600x600
milky_way milky_way_sagittarius 2026-07-14T23:30:00Z --projection perspective --azimuth 183 --altitude 33 --fov 30 --size 600x450
milky_way milky_way_winter 2026-01-18T22:30:00Z --size 600x600
