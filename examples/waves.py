"""What the tables.py of dynamic examples share: a reference in one dimension, and what lies in results.h5.

In uniaxial strain the first Piola-Kirchhoff stress is the Cauchy stress, P = sigma(D) with D = 1 + du/dX, for every law:
rho u_tt = dP/dX + b is solved by central differences on a fine grid, with Poisson's ratio 0.
"""
try:
    import numpy as np
    import h5py
except ImportError:
    import os
    import sys

    if sys.executable != "/usr/bin/python3" and os.path.exists("/usr/bin/python3"):
        os.execv("/usr/bin/python3", ["/usr/bin/python3", *sys.argv])
    sys.exit("needs a python3 with numpy and h5py (Debian: python3-h5py)")

STRESS = {
    "linear_large": lambda d, e: e * (d - 1),
    "neo_hookean": lambda d, e: e / 2 * (d - 1 / d),
    "hypoelastic": lambda d, e: e * (1 - 1 / d),
}


def reference(law, length, modulus, density, end, force=0.0, velocity=lambda x: 0 * x, free_end=False, cells=800):
    """Times, positions X, u(t, X) and sigma(t, X) of a bar held at X = 0, and at X = length unless that end is free."""
    h = length / cells
    x = np.linspace(0, length, cells + 1)
    steps = int(np.ceil(end / (0.5 * h / np.sqrt(1.6 * modulus / density))))
    dt = end / steps
    mass = np.full(cells + 1, density * h)
    mass[[0, -1]] /= 2
    u, v = 0 * x, velocity(x).astype(float)
    times, states, stresses = [0.0], [u.copy()], [STRESS[law](1 + np.diff(u) / h, modulus)]
    for k in range(steps):
        stress = STRESS[law](1 + np.diff(u) / h, modulus)
        push = mass * force
        push[:-1] += stress
        push[1:] -= stress
        v += (dt if k else dt / 2) * push / mass  # velocities live between the steps
        v[0] = 0
        if not free_end:
            v[-1] = 0
        u = u + dt * v
        if (k + 1) % max(steps // 1000, 1) == 0 or k + 1 == steps:
            times.append((k + 1) * dt)
            states.append(u.copy())
            stresses.append(STRESS[law](1 + np.diff(u) / h, modulus))
    return np.array(times), x, np.array(states), np.array(stresses)


def probe(folder, name):
    """The history of a probe: a dictionary of arrays."""
    with h5py.File(f"{folder}/results.h5") as file:
        return {key: file[f"probes/{name}/{key}"][:] for key in file[f"probes/{name}"]}


def last_step(folder):
    """Original positions, displacements and stresses of the points at the last saved step."""
    with h5py.File(f"{folder}/results.h5") as file:
        points = file["steps"][sorted(file["steps"], key=int)[-1]]["points"]
        displacement = points["displacement"][:, :2]
        return points["position"][:, :2] - displacement, displacement, points["stress"][:]


def axes_of(rows, columns, size):
    """Figure and axes of matplotlib; none where it is not there."""
    try:
        import matplotlib
    except ImportError:
        return None, None
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    return plt.subplots(rows, columns, figsize=size, constrained_layout=True)
