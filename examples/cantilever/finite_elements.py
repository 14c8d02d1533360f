#!/usr/bin/env python3
"""The cantilever by bilinear finite elements whose mesh moves with the material: what the runs converge to.

    examples/cantilever/finite_elements.py

Needs numpy and scipy. Small strains, incremental stress, a pressure that follows the top, as in clamped.json. A Gauss
point keeps its weight, as a material point keeps its volume, or takes the area of the deformed element anew.
"""
import numpy
import scipy.sparse
import scipy.sparse.linalg

LENGTH, HEIGHT, PRESSURE = 10.0, 2.0, 1500.0  # m, m, Pa
YOUNGS_MODULUS, POISSONS_RATIO = 1e6, 0.25
LAMBDA = YOUNGS_MODULUS * POISSONS_RATIO / ((1 + POISSONS_RATIO) * (1 - 2 * POISSONS_RATIO))
MU = YOUNGS_MODULUS / (2 * (1 + POISSONS_RATIO))
STIFFNESS = numpy.array([[LAMBDA + 2 * MU, LAMBDA, 0], [LAMBDA, LAMBDA + 2 * MU, 0], [0, 0, MU]])
GAUSS = [(a / 3**0.5, b / 3**0.5) for b in (-1, 1) for a in (-1, 1)]


def strain_matrices(corners, a, b):
    """B (elements, 3, 8) at one Gauss point, and the area it stands for."""
    slope = 0.25 * numpy.array([[b - 1, 1 - b, 1 + b, -1 - b], [a - 1, -1 - a, 1 + a, 1 - a]])
    jacobian = slope @ corners
    gradient = numpy.linalg.solve(jacobian, numpy.broadcast_to(slope, (len(corners), 2, 4)))
    matrix = numpy.zeros((len(corners), 3, 8))
    matrix[:, 0, 0::2] = matrix[:, 2, 1::2] = gradient[:, 0]
    matrix[:, 1, 1::2] = matrix[:, 2, 0::2] = gradient[:, 1]
    return matrix, numpy.linalg.det(jacobian)


def pressure_force(x, top):
    """Of the whole pressure on the current top edge, whose nodes run with x [N/m]."""
    force = numpy.zeros_like(x)
    chord = x[top[1:]] - x[top[:-1]]
    half = 0.5 * PRESSURE * numpy.column_stack([chord[:, 1], -chord[:, 0]])
    force[top[:-1]] += half
    force[top[1:]] += half
    return force.ravel()


def deflection(rows, steps, loading="incremental", keep_weights=True, central=False):
    """Of the middle of the tip [m], on 5 rows × rows elements; the left edge fixed, or a roller with one fixed node."""
    columns = 5 * rows
    number = numpy.arange((columns + 1) * (rows + 1)).reshape(rows + 1, columns + 1)
    x = numpy.stack(numpy.meshgrid(numpy.linspace(0, LENGTH, columns + 1), numpy.linspace(0, HEIGHT, rows + 1)), -1)
    x = x.reshape(-1, 2)
    nodes = numpy.stack([number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]], -1).reshape(-1, 4)
    unknowns = numpy.stack([2 * nodes, 2 * nodes + 1], -1).reshape(-1, 8)
    held = number[rows // 2, :1] if central else number[:, 0]
    free = numpy.setdiff1d(numpy.arange(x.size), [*(2 * number[:, 0]), *(2 * held + 1)])
    stress = numpy.zeros((4, len(nodes), 3))
    kept = [strain_matrices(x[nodes], *g)[1] for g in GAUSS]
    tip = number[rows // 2, columns]
    for step in range(1, steps + 1):
        matrices, areas = zip(*(strain_matrices(x[nodes], *g) for g in GAUSS))
        weights = kept if keep_weights else areas
        block = sum(w[:, None, None] * (B.transpose(0, 2, 1) @ STIFFNESS @ B) for B, w in zip(matrices, weights))
        place = numpy.repeat(unknowns, 8, 1).ravel(), numpy.tile(unknowns, 8).ravel()
        matrix = scipy.sparse.csc_matrix((block.ravel(), place))[free][:, free]
        force = pressure_force(x, number[rows]) / steps
        if loading == "residual":
            force *= step
            for B, w, s in zip(matrices, weights, stress):
                numpy.subtract.at(force, unknowns, w[:, None] * numpy.einsum("eki,ek->ei", B, s))
        move = numpy.zeros(x.size)
        move[free] = scipy.sparse.linalg.spsolve(matrix, force[free])
        for B, s in zip(matrices, stress):
            s += numpy.einsum("kl,elj,ej->ek", STIFFNESS, B, move[unknowns])
        x = x + move.reshape(-1, 2)
    return HEIGHT / 2 - x[tip, 1]


def row(*entries):
    print("| " + " | ".join(str(e) for e in entries) + " |")


VARIANTS = [(loading, kept) for kept in (True, False) for loading in ("incremental", "residual")]
HEAD = [f"{loading}, weights {'kept' if kept else 'of the deformed mesh'}" for loading, kept in VARIANTS]

print("Left edge fixed, 5 steps over the mesh:\n")
row("elements", "1 step", *HEAD, "incremental, weights kept, one node fixed")
row(*["---:"] * 7)
for rows in (8, 16, 32, 64):
    row(f"{5 * rows} × {rows}", f"{deflection(rows, 1):.4f}",
        *(f"{deflection(rows, 5, *variant):.4f}" for variant in VARIANTS), f"{deflection(rows, 5, central=True):.4f}")

print("\nThe number of load steps, 80 × 16 elements:\n")
row("steps", *HEAD)
row(*["---:"] * 5)
for steps in (1, 2, 5, 20, 80):
    row(steps, *(f"{deflection(16, steps, *variant):.4f}" for variant in VARIANTS))
