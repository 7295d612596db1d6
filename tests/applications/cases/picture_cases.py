"""Tests of pictures; a kind of run_case.py."""

import os

from case import Failed, require


def check_picture(path):
    """A picture of some size, with a background, lines and colours: no pixel
    value fills nearly all of it, and there are many."""
    import numpy
    from matplotlib import image
    try:
        pixels = image.imread(path, format="png")
    except (OSError, SyntaxError, ValueError) as problem:
        raise Failed(f"{path} is no picture: {problem}") from problem
    height, width = pixels.shape[:2]
    colours, counts = numpy.unique(
        (255 * pixels.reshape(width * height, -1)).round().astype(int)
        @ (1 << 8 * numpy.arange(pixels.size // (width * height))),
        return_counts=True)
    share = counts.max() / (width * height)
    print(f"{path}: {width} x {height}, {len(colours)} colours, the commonest "
          f"on {100. * share:.1f} %")
    require(width >= 400 and height >= 200, f"{path} is {width} x {height}")
    require(len(colours) >= 16 and share < 0.99,
            f"{path} is nearly all of one colour")


def pictures(case):
    """The run draws the named pictures by itself, and they are not empty."""
    output = case.straight()
    log = case.logs[output]
    if f"pictures in {output}/pictures" not in log:
        raise Failed("the run does not say that it has drawn pictures")
    for name in case.options.compare:
        check_picture(os.path.join(output, "pictures", name))


KINDS = {"pictures": pictures}
