# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of a scene as few bytes, and texts that no deck can break a page with."""
import base64
import io
import json

import numpy
from matplotlib import pyplot

STEPS, NOWHERE = 65534, 65535  # places are whole numbers from 0 to STEPS over the frame; NOWHERE is a NaN
QUALITY = 85  # of pictures, of 100
SHADES, NOTHING = 254, 255  # numbers of a scale are from 0 to SHADES; NOTHING is a NaN


def text_of(array):
    """Bytes of an array, little-endian, in base64."""
    array = numpy.ascontiguousarray(array)
    return base64.b64encode(array.astype(array.dtype.newbyteorder("<")).tobytes()).decode()


def whole(values, low, high, steps, missing, dtype):
    """Numbers between two bounds as whole ones; what is beyond is at the bound, what is none is `missing`."""
    values = numpy.asarray(values, dtype=float)
    finite = numpy.isfinite(values)
    shares = numpy.clip((numpy.where(finite, values, low) - low) / (high - low), 0, 1)
    return numpy.where(finite, numpy.rint(steps * shares), missing).astype(dtype)


def places(points, limits):
    """Places in the frame, x and y after each other, as text."""
    points = numpy.asarray(points, dtype=float).reshape(-1, 2)
    columns = [whole(points[:, k], limits[2 * k], limits[2 * k + 1], STEPS, NOWHERE, numpy.uint16) for k in (0, 1)]
    return text_of(numpy.column_stack(columns))


def shades(values, scale):
    """Numbers as places on a scale of colours, as text."""
    return text_of(whole(values, scale.low, scale.high, SHADES, NOTHING, numpy.uint8))


def jpeg_of(image):
    """A picture, colours from 0 to 1, as text."""
    file = io.BytesIO()
    pyplot.imsave(file, image, format="jpeg", pil_kwargs={"quality": QUALITY})
    return base64.b64encode(file.getvalue()).decode()


def colours_of(scale):
    """The colours of a scale, red, green and blue of each shade, as text."""
    return text_of(numpy.rint(255 * scale.mappable().get_cmap()(numpy.linspace(0, 1, SHADES + 1))[:, :3]).astype(numpy.uint8))


def json_in_html(data):
    """JSON that holds no < > & and so can end no script."""
    text = json.dumps(data, separators=(",", ":"), allow_nan=False)
    for letter in "<>&\u2028\u2029":
        text = text.replace(letter, f"\\u{ord(letter):04x}")
    return text
