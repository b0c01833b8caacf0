#!/usr/bin/env python3
"""Prints a LAS file as ASPRS' "LAS Specification Version 1.2" lays it out: the header, then a line a point."""
import struct
import sys

data = open(sys.argv[1], "rb").read()
signature, major, minor = data[0:4], data[24], data[25]
header_size, offset, records = struct.unpack_from("<HII", data, 94)
point_format, length, count = struct.unpack_from("<BHI", data, 104)
returns = struct.unpack_from("<5I", data, 111)
scale, origin = struct.unpack_from("<3d", data, 131), struct.unpack_from("<3d", data, 155)
max_x, min_x, max_y, min_y, max_z, min_z = struct.unpack_from("<6d", data, 179)
assert signature == b"LASF" and header_size == 227 and point_format == 0 and length == 20
assert len(data) == offset + count * length and returns == (count, 0, 0, 0, 0)
print(f"LAS {major}.{minor} {count} points {records} records")
for i in range(count):
    x, y, z, intensity, flags, kind, angle, user, source = struct.unpack_from("<3iHBBbBH", data, offset + i * length)
    x, y, z = (step * s + o for step, s, o in zip((x, y, z), scale, origin))
    assert min_x - 1e-9 <= x <= max_x + 1e-9 and min_y - 1e-9 <= y <= max_y + 1e-9 and min_z - 1e-9 <= z <= max_z + 1e-9
    assert flags & 7 == 1 and flags >> 3 & 7 == 1
    print(f"{x:.6f} {y:.6f} {z:.6f} {intensity}")
