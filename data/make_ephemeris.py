#!/usr/bin/env python3
"""Makes data/ephemeris_1960_2059.bin: Sun, Moon, planets, the Moon's axes and the Earth's nutation as one compact table.

Needs the Debian packages python3-numpy, python3-erfa and casacore-data-jpl-de405. Usage:

    /usr/bin/python3 data/make_ephemeris.py data/ephemeris_1960_2059.bin

JPL's development ephemeris DE405 (Standish 1998, JPL IOM 312.F-98-048) comes as Chebyshev polynomials of nanometre
precision. This refits what a sky needs with fewer orders and integer coefficients. Nutation (IAU 2000A adjusted to
IAU 2006) is sampled from ERFA. renderer/astro/ephemeris_table.hpp describes the file.
"""

import hashlib
import struct
import sys
from dataclasses import dataclass
from typing import Callable

import erfa
import numpy as np

FOLDER = "/usr/share/casacore/data/ephemerides/DE405/"

# ---- DE405 as casacore keeps it -------------------------------------------------------------------------------------

# The table's arrays (table.f0i, little endian): a header of 16 bytes, then a record every 8160: 12 bytes of shape
# (uses 1, dimensions 1, length 1018), 1016 coefficients and two zeros. Its dates (table.f0) stand as pairs (MJD of the
# record's beginning, place in table.f0i).
HEADER_BYTES = 16
STRIDE = 8160
SHAPE = struct.pack("<3i", 1, 1, 1018)
RECORD_DAYS = 32.0
FIRST_MJD = 36912.0
MJD_ZERO = 2400000.5

# (first coefficient, coefficients, intervals a record) of three components each: DE405's own directory.
DIRECTORY = {
    "mercury": (0, 14, 4),
    "venus": (168, 10, 2),
    "earth-moon": (228, 13, 2),
    "mars": (306, 11, 1),
    "jupiter": (339, 8, 1),
    "saturn": (363, 7, 1),
    "uranus": (384, 6, 1),
    "neptune": (402, 6, 1),
    "moon": (438, 13, 8),
    "sun": (750, 11, 2),
    "moon axes": (896, 10, 4),
}


def read_records():
    """All records, one a row."""
    with open(FOLDER + "table.f0i", "rb") as file:
        arrays = file.read()
    with open(FOLDER + "table.f0", "rb") as file:
        dates = file.read()
    count = (len(arrays) - HEADER_BYTES + 4) // STRIDE
    rows = []
    for i in range(count):
        place = HEADER_BYTES + i * STRIDE
        if arrays[place : place + len(SHAPE)] != SHAPE:
            sys.exit(f"{FOLDER}table.f0i: byte {place}: not the head of a record of 1018 numbers")
        if struct.pack("<dq", FIRST_MJD + i * RECORD_DAYS, place) not in dates:
            sys.exit(f"{FOLDER}table.f0: no record {i} for MJD {FIRST_MJD + i * RECORD_DAYS}")
        rows.append(np.frombuffer(arrays, "<f8", 1018, place + len(SHAPE)))
    return np.array(rows)


RECORDS = read_records()
SPAN_DAYS = len(RECORDS) * RECORD_DAYS


def clenshaw(c, x):
    """Sum of c[..., k] T_k(x)."""
    b1 = np.zeros(np.broadcast_shapes(c.shape[:-1], x.shape))
    b2 = b1
    for k in range(c.shape[-1] - 1, 0, -1):
        b1, b2 = c[..., k] + 2.0 * x * b1 - b2, b1
    return c[..., 0] + x * b1 - b2


def de405(body, days):
    """Barycentric place in km (the Moon's from the Earth's centre, its axes' angles in rad) at days since FIRST_MJD."""
    first, orders, intervals = DIRECTORY[body]
    length = RECORD_DAYS / intervals
    pieces = RECORDS[:, first : first + 3 * orders * intervals].reshape(-1, 3, orders)
    index = np.clip(np.floor(days / length).astype(int), 0, len(pieces) - 1)
    x = 2.0 * (days - index * length) / length - 1.0
    return clenshaw(pieces[index], x[..., None])


# ---- What is tabulated ----------------------------------------------------------------------------------------------


def heliocentric(body):
    return lambda days: de405(body, days) - de405("sun", days)


def nutation(days):
    """In longitude, in obliquity, and the CIO locator s + XY/2, rad."""
    dpsi, deps = erfa.nut06a(MJD_ZERO + FIRST_MJD, days)
    return np.stack([dpsi, deps, erfa.s06(MJD_ZERO + FIRST_MJD, days, 0.0, 0.0)], -1)


@dataclass
class Series:
    name: str
    segment_days: float
    orders: int
    quantum: float  # unit of the integers: km or rad
    largest_error: float  # allowed, same unit
    value: Callable
    turns: bool = False  # the third component is an angle that counts turns: keep it near 0


SERIES = [
    Series("moon", 8, 13, 0.00025, 0.002, lambda days: de405("moon", days)),
    Series("earth-moon", 32, 10, 0.08, 0.3, heliocentric("earth-moon")),
    Series("sun", 32, 7, 0.005, 0.05, lambda days: de405("sun", days)),
    Series("mercury", 16, 12, 0.05, 1.0, heliocentric("mercury")),
    Series("venus", 32, 9, 0.06, 1.0, heliocentric("venus")),
    Series("mars", 32, 8, 0.12, 1.0, heliocentric("mars")),
    Series("jupiter", 96, 6, 0.4, 5.0, heliocentric("jupiter")),
    Series("saturn", 96, 6, 0.8, 10.0, heliocentric("saturn")),
    Series("uranus", 96, 6, 1.5, 15.0, heliocentric("uranus")),
    Series("neptune", 96, 5, 2.5, 20.0, heliocentric("neptune")),
    Series("moon axes", 16, 11, 2e-9, 5e-7, lambda days: de405("moon axes", days), turns=True),
    Series("nutation", 8, 10, 1e-11, 2e-10, nutation),
]


def fit(series):
    """Integers [segment, order, component]: the polynomials through the Chebyshev-Lobatto points, which include both
    ends, so that neighbours meet."""
    segments = round(SPAN_DAYS / series.segment_days)
    if segments * series.segment_days != SPAN_DAYS:
        sys.exit(f"{series.name}: segments of {series.segment_days} days do not fill {SPAN_DAYS}")
    last = series.orders - 1
    angle = np.pi * np.arange(series.orders) / last
    days = (np.arange(segments)[:, None] + 0.5 * (np.cos(angle) + 1.0)) * series.segment_days
    values = series.value(days)
    if series.turns:
        values[..., 2] -= 2.0 * np.pi * np.round(values[:, last // 2, 2] / (2.0 * np.pi))[:, None]
    halves = np.ones(series.orders)
    halves[[0, last]] = 0.5
    coefficients = np.empty_like(values)
    for k in range(series.orders):
        weights = 2.0 / last * halves[k] * halves * np.cos(k * angle)
        coefficients[:, k] = sum(weights[j] * values[:, j] for j in range(series.orders))
    return np.round(coefficients / series.quantum).astype(np.int64)


def wide_orders(integers):
    """How many of the lowest orders need 32 bits; the others have 16."""
    largest = np.abs(integers).max(axis=(0, 2))
    if largest.max() > 2**31 - 1:
        sys.exit("a coefficient does not fit into 32 bits: the quantum is too small")
    return int(np.max(np.nonzero(largest > 2**15 - 1), initial=-1)) + 1


def pack(integers, wide):
    """Segment by segment, from the highest order to the lowest, the three components of an order together."""
    falling = integers[:, ::-1]
    narrow = falling.shape[1] - wide
    rows = [segment[:narrow].astype("<i2").tobytes() + segment[narrow:].astype("<i4").tobytes() for segment in falling]
    return b"".join(rows)


def measure(series, integers):
    """Worst error of the vector against the source at 60 instants in each segment, and of its rate at 7."""
    def table(x):
        return clenshaw(integers.transpose(0, 2, 1)[:, None] * series.quantum, x[None, :, None])

    x = np.linspace(-1.0, 1.0, 60)
    days = (np.arange(len(integers))[:, None] + 0.5 * (x + 1.0)) * series.segment_days
    error = table(x) - series.value(days)
    if series.turns:
        error[..., 2] = (error[..., 2] + np.pi) % (2.0 * np.pi) - np.pi
    step = 1e-3
    x = np.linspace(-1.0 + step, 1.0 - step, 7)
    days = (np.arange(len(integers))[:, None] + 0.5 * (x + 1.0)) * series.segment_days
    half = 0.5 * series.segment_days * step
    rate = (table(x + step) - table(x - step)) - (series.value(days + half) - series.value(days - half))
    if series.turns:
        rate[..., 2] = (rate[..., 2] + np.pi) % (2.0 * np.pi) - np.pi
    return np.linalg.norm(error, axis=-1), np.abs(rate).max() / (2.0 * half)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    header = struct.Struct("<8sddII")
    row = struct.Struct("<16sdIIII")
    rows = []
    blocks = []
    place = header.size + len(SERIES) * row.size
    print("| series | segments | orders (32-bit) | bytes | worst error | RMS | worst error of the rate |")
    print("|---|---|---|---|---|---|---|")
    for series in SERIES:
        integers = fit(series)
        wide = wide_orders(integers)
        block = pack(integers, wide)
        error, rate = measure(series, integers)
        angular = series.name in ("moon axes", "nutation")
        unit, scale = ('"', np.degrees(3600.0)) if angular else ("km", 1.0)
        rms = np.sqrt(np.mean(error**2))
        print(f"| {series.name} | {len(integers)} x {series.segment_days} d | {series.orders} ({wide}) | {len(block)} | "
              f"{error.max() * scale:.2g} {unit} | {rms * scale:.2g} {unit} | {rate * scale:.2g} {unit}/d |")
        if error.max() > series.largest_error:
            sys.exit(f"{series.name}: worst error {error.max()} exceeds {series.largest_error}")
        rows.append(row.pack(series.name.encode(), series.quantum, place, len(integers), series.orders, wide))
        blocks.append(block)
        place += len(block)
    head = header.pack(b"VESPEPH1", MJD_ZERO + FIRST_MJD, SPAN_DAYS, len(SERIES), place)
    content = head + b"".join(rows) + b"".join(blocks)
    with open(sys.argv[1], "wb") as file:
        file.write(content)
    print(f"\n{len(content)} bytes, SHA-256 {hashlib.sha256(content).hexdigest()}")


main()
