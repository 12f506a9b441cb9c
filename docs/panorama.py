#!/usr/bin/python3
"""Writes docs/PANORAMA.md and its chart: what `vesper-catalog panorama` costs, and beside it the packaged reproject.

    /usr/bin/python3 docs/panorama.py build/release/bin/vesper-catalog [FOLDER FOR 8 GB OF SPARSE FILES [--alone]]

With --alone without reproject, which takes some minutes of its own for a job that is small here.

Needs Debian's python3-reproject, python3-pil and openimageio-tools. Keeps the times of the sparse files in that folder
and takes them from there the next time. Takes some minutes.
"""
import json
import math
import os
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np
from PIL import Image
from astropy.io import fits
from astropy.wcs import WCS

TOOL = os.path.abspath(sys.argv[1])
DOCS = os.path.dirname(os.path.abspath(__file__))
FACE = 1024
# The job for both.
SAME_FACE = 256
WIDTH, HEIGHT = 1800, 900


def band(longitude, latitude):
    """A band along the galactic equator, on 0.2: brightness without a unit."""
    return 0.2 + np.exp(-30.0 * np.sin(latitude) ** 2) * (1.5 + np.cos(latitude) * np.cos(longitude))


BAND_TOTAL = 0.8 * math.pi + 3.0 * math.pi * math.sqrt(math.pi / 30.0) * math.erf(math.sqrt(30.0))


def header(width):
    scale = 360.0 / width
    h = fits.Header()
    h["CTYPE1"], h["CTYPE2"] = "GLON-CAR", "GLAT-CAR"
    h["CRPIX1"], h["CRPIX2"] = 0.5 * (width + 1), 0.5 * (width // 2 + 1)
    h["CDELT1"], h["CDELT2"] = -scale, scale
    h["CRVAL1"] = h["CRVAL2"] = 0.0
    return h


def run(arguments):
    """Wall, processor seconds and peak memory in MB of the tool; its report."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    child = subprocess.Popen([TOOL, "--quiet", "panorama", *arguments, "--json"], stdout=subprocess.PIPE)
    report = child.stdout.read()
    _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        sys.exit("vesper-catalog failed")
    wall = time.monotonic() - start
    return wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.0, json.loads(report)


def sparse(path, width):
    """A FITS file of width x width/2 x 3 floats, all zero, that takes no room."""
    h = fits.Header()
    h["SIMPLE"], h["BITPIX"], h["NAXIS"] = True, -32, 3
    h["NAXIS1"], h["NAXIS2"], h["NAXIS3"] = width, width // 2, 3
    h.update(header(width))
    text = h.tostring().encode()
    size = len(text) + -(-4 * width * (width // 2) * 3 // 2880) * 2880
    with open(path, "wb") as f:
        f.write(text)
        f.truncate(size)


# The axes of the faces as shaders/lib/cube_map.glsl has them: picture right, picture up, outward.
X, Y, Z = np.eye(3)
FACES = [(Z, Y, X), (-Z, Y, -X), (X, Z, Y), (X, -Z, -Y), (-X, Y, Z), (X, Y, -Z)]


def texels():
    place = (2.0 * np.arange(SAME_FACE) + 1.0) / SAME_FACE - 1.0
    right, up = np.meshgrid(place, -place)
    return right, up, (2.0 / SAME_FACE) ** 2 / (1.0 + right**2 + up**2) ** 1.5


def band_on_face(axes, rotation):
    right, up, _ = texels()
    d = right[..., None] * axes[0] + up[..., None] * axes[1] + axes[2]
    d = (d / np.linalg.norm(d, axis=-1, keepdims=True)) @ rotation.T
    return band(np.arctan2(d[..., 1], d[..., 0]), np.arcsin(d[..., 2]))


# Galactic from ICRS axes (ESA 1997, Hipparcos catalogue, volume 1, equation 1.5.11).
GALACTIC = np.array([[-0.0548755604, -0.8734370902, -0.4838350155],
                     [0.4941094279, -0.4448296300, 0.7469822445],
                     [-0.8676661490, -0.1980763734, 0.4559837762]])


def face_header(axes):
    """A TAN picture that is the face, seen from inside: its columns run along `right`, its rows down."""
    right, up, outward = axes
    h = fits.Header()
    h["CTYPE1"], h["CTYPE2"] = "RA---TAN", "DEC--TAN"
    h["CRPIX1"] = h["CRPIX2"] = 0.5 * (SAME_FACE + 1)
    h["CRVAL1"] = math.degrees(math.atan2(outward[1], outward[0])) % 360.0
    h["CRVAL2"] = math.degrees(math.asin(outward[2]))
    h["LONPOLE"] = 180.0  # the standard's default turns the northern face round
    a, d = math.radians(h["CRVAL1"]), math.radians(h["CRVAL2"])
    east = np.array([-math.sin(a), math.cos(a), 0.0])
    north = np.array([-math.sin(d) * math.cos(a), -math.sin(d) * math.sin(a), math.cos(d)])
    step = math.degrees(2.0 / SAME_FACE)
    h["CD1_1"], h["CD1_2"] = step * (right @ east), step * (-up @ east)
    h["CD2_1"], h["CD2_2"] = step * (right @ north), step * (-up @ north)
    return h


def errors(faces):
    """Errors of a map of the band: of its total, and the worst and RMS one of a texel, in percent."""
    _, _, solid_angle = texels()
    total, worst, squares = 0.0, 0.0, 0.0
    for axes, face in zip(FACES, faces):
        off = face - band_on_face(axes, GALACTIC)
        total += np.sum(face * solid_angle)
        worst = max(worst, np.max(np.abs(off)) / 2.7)
        squares += np.mean((off / 2.7) ** 2) / 6.0
    return abs(total / BAND_TOTAL - 1.0) * 100.0, worst * 100.0, math.sqrt(squares) * 100.0


def compare(folder):
    x, y = np.meshgrid(np.arange(WIDTH), np.arange(HEIGHT))
    longitude = np.radians(-(x + 0.5 - WIDTH / 2) * 360.0 / WIDTH)
    latitude = np.radians((y + 0.5 - HEIGHT / 2) * 360.0 / WIDTH)
    picture = band(longitude, latitude).astype(np.float32)
    path = os.path.join(folder, "band.fits")
    fits.PrimaryHDU(picture, header(WIDTH)).writeto(path, overwrite=True)
    out = os.path.join(folder, "band.exr")
    ours = run([path, "-o", out, "--face", str(SAME_FACE), "--zero-point", "12.58356"])  # of 1 cd/m2
    flat = os.path.join(folder, "y.tif")
    subprocess.run(["oiiotool", out, "--ch", "Y", "-d", "float", "--compression", "none", "-o", flat], check=True)
    values = np.asarray(Image.open(flat)).astype(float)
    ours_errors = errors([values[i * SAME_FACE:(i + 1) * SAME_FACE] for i in range(6)])

    from reproject import reproject_exact
    usage = resource.getrusage(resource.RUSAGE_SELF)
    start = time.monotonic()
    with fits.open(path) as file:
        plane, wcs = file[0].data, WCS(file[0].header)
        theirs = []
        for axes in FACES:
            theirs.append(reproject_exact((plane, wcs), WCS(face_header(axes)), shape_out=(SAME_FACE, SAME_FACE),
                                          parallel=False, return_footprint=False))
    wall = time.monotonic() - start
    after = resource.getrusage(resource.RUSAGE_SELF)
    cpu = after.ru_utime + after.ru_stime - usage.ru_utime - usage.ru_stime
    gaps = sum(int(np.sum(~np.isfinite(face))) for face in theirs)
    theirs = [np.nan_to_num(face) for face in theirs]
    return ours, ours_errors, (wall, cpu, after.ru_maxrss / 1024.0), errors(theirs), gaps


def chart(rows):
    """Processor seconds against megapixels, both logarithmic, with the line of one slope."""
    left, top, width, height = 70, 20, 520, 300
    lx = [math.log10(r[0] ** 2 / 2 / 1e6) for r in rows]
    ly = [math.log10(r[2]) for r in rows]
    x0, x1 = math.floor(min(lx)), math.ceil(max(lx))
    y0, y1 = math.floor(min(ly)), math.ceil(max(ly))
    px = lambda v: left + (v - x0) / (x1 - x0) * width
    py = lambda v: top + height - (v - y0) / (y1 - y0) * height
    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{left + width + 20}" height="{top + height + 50}" '
           'font-family="sans-serif" font-size="12">', '<rect width="100%" height="100%" fill="white"/>']
    for i in range(x0, x1 + 1):
        svg.append(f'<path d="M{px(i)} {top}V{top + height}" stroke="#ddd"/><text x="{px(i)}" y="{top + height + 16}" '
                   f'text-anchor="middle">{10.0 ** i:g}</text>')
    for i in range(y0, y1 + 1):
        svg.append(f'<path d="M{left} {py(i)}H{left + width}" stroke="#ddd"/><text x="{left - 6}" y="{py(i) + 4}" '
                   f'text-anchor="end">{10.0 ** i:g}</text>')
    a, b = lx[-1], ly[-1]
    low = max(x0, a - (b - y0))
    svg.append(f'<path d="M{px(low)} {py(b - (a - low))}L{px(a)} {py(b)}" stroke="#999" stroke-dasharray="5 4"/>')
    svg.append(f'<path d="M{" L".join(f"{px(u):.1f} {py(v):.1f}" for u, v in zip(lx, ly))}" fill="none" stroke="#06c" '
               'stroke-width="2"/>')
    svg += [f'<circle cx="{px(u):.1f}" cy="{py(v):.1f}" r="4" fill="#06c"/>' for u, v in zip(lx, ly)]
    svg.append(f'<text x="{left + width / 2}" y="{top + height + 38}" text-anchor="middle">megapixels of three floats'
               '</text>')
    svg.append(f'<text transform="translate(18 {top + height / 2}) rotate(-90)" text-anchor="middle">processor seconds'
               '</text></svg>')
    with open(os.path.join(DOCS, "pictures", "panorama_cost.svg"), "w") as f:
        f.write("\n".join(svg) + "\n")


def main():
    folder = sys.argv[2] if len(sys.argv) > 2 else tempfile.gettempdir()
    folder = tempfile.mkdtemp(dir=folder)
    kept = os.path.join(folder, "..", "panorama_rows.json")  # the sparse files take the longest
    rows = json.load(open(kept)) if os.path.exists(kept) else []
    for width in () if rows else (900, 1800, 3600, 7200, 18000, 36000):
        path = os.path.join(folder, "sparse.fits")
        sparse(path, width)
        wall, cpu, memory, _ = run([path, "-o", os.path.join(folder, "out.exr"), "--face", str(FACE), "--zero-point", "20"])
        rows.append((width, wall, cpu, memory))
        print(rows[-1], file=sys.stderr)
        os.remove(path)
    json.dump(rows, open(kept, "w"))
    chart(rows)
    with open(os.path.join(DOCS, "panorama_head.md")) as f:
        page = f.read()
    page += "| picture | wall | processor | memory |\n|---|---|---|---|\n"
    for width, wall, cpu, memory in rows:
        page += f"| {width} x {width // 2} x 3 | {wall:.1f} s | {cpu:.1f} s | {memory:.0f} MB |\n"
    page += f"""
![Processor seconds against megapixels, with a line of slope one](pictures/panorama_cost.svg)

The floor on the left is what a map of {FACE} costs whatever it is made from.
"""
    if "--alone" not in sys.argv:
        ours, ours_errors, theirs, theirs_errors, gaps = compare(folder)
        page += f"""
## Beside reproject
The same job for both in one run: {WIDTH} x {HEIGHT} x 1 in galactic CAR to six faces of {SAME_FACE} along ICRS axes, a band
of known integral (0.2 + exp(-30 sin(b)^2) (1.5 + cos(b) cos(l))). `reproject_exact` of Debian's python3-reproject makes six
TAN pictures. Errors are against the band at the middles of texels, of which a mean over pixels is a little off by itself.

| | wall | processor | total light off by | worst texel off by | RMS | texels without a value |
|---|---|---|---|---|---|---|
| vesper-catalog panorama, reading and writing included | {ours[0]:.1f} s | {ours[1]:.1f} s | {ours_errors[0]:.2g} % | {ours_errors[1]:.2g} % of the peak | {ours_errors[2]:.2g} % | 0 |
| reproject_exact, from memory to memory | {theirs[0]:.1f} s | {theirs[1]:.1f} s | {theirs_errors[0]:.2g} % | {theirs_errors[1]:.2g} % of the peak | {theirs_errors[2]:.2g} % | {gaps} |

That is {theirs[1] / ours[1]:.0f} times the processor time.
"""
    with open(os.path.join(DOCS, "PANORAMA.md"), "w") as f:
        f.write(page)
    for name in os.listdir(folder):
        os.remove(os.path.join(folder, name))
    os.rmdir(folder)


main()
