# What every script of pictures starts with. Exit status 77 says that a library is missing.

import os
import sys

try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy as np
except ImportError:
    sys.exit(77)


def plain(text):
    """The text as it stands, without formulas between dollar signs."""
    return str(text).replace("$", r"\$")


def save(figure, folder, name):
    """Writes a picture, whole or not at all."""
    part = os.path.join(folder, name + ".part")
    figure.savefig(part, format="png")
    os.replace(part, os.path.join(folder, name))
    plt.close(figure)
