#!/usr/bin/python3
# Draws 200 linear systems and writes their invariant zeros by octave-control beside them; those of the square
# ones agree with generalised eigenvalues by scipy. Written once with Debian's octave-control 3.4.0:
#   /usr/bin/python3 zeros.py > zeros.csv
import subprocess

import numpy as np
from scipy.linalg import eigvals

rng = np.random.default_rng(20)


def feedthrough(k, rank):
    return rng.standard_normal((k, rank)) @ rng.standard_normal((rank, k)) if rank else np.zeros((k, k))


def mixing(rows, columns):
    """Whole numbers of full rank, so that products are exact."""
    matrix = rng.integers(-3, 4, (rows, columns)).astype(float)
    matrix[: min(rows, columns), : min(rows, columns)] += 5 * np.eye(min(rows, columns))
    return matrix


def drawn(number):
    sampled, single = number % 2 == 1, number % 4 < 2
    n = int(rng.integers(1, 7))
    k = 1 if single else int(rng.integers(2, 4))
    A = rng.standard_normal((n, n))
    if sampled:
        A *= 0.9 / max(abs(np.linalg.eigvals(A)))
    B, C = rng.standard_normal((n, k)), rng.standard_normal((k, n))
    rank = int(rng.integers(0, k + 1))
    D = feedthrough(k, rank)
    if rank == 0 and n > 2 and number % 3 == 0:  # the first input moves the first output later
        C[0], B[0] = 0, 0
        C[0, 0] = 1
    four_digits = np.vectorize(lambda x: float(f"{x:.4g}"))
    A, B, C, D = map(four_digits, (A, B, C, D))
    if not single and number % 5 == 0:
        M = mixing(k + 1, k)
        C, D = M @ np.round(5 * C), M @ np.round(5 * D)
    elif not single and number % 5 == 1:
        M = mixing(k, k + 1)
        B, D = np.round(5 * B) @ M, np.round(5 * D) @ M
    return (0.01 if sampled else 0.0), A, B, C, D


def text(matrix):
    return ";".join(" ".join(repr(float(x)) for x in row) for row in matrix)


def by_octave(systems):
    script = "pkg load control;\n"
    for T, *matrices in systems:
        script += f"z = zero(ss({','.join('[' + text(one) + ']' for one in matrices)}{f',{T}' if T else ''}));"
        script += "if (! isempty(z)) printf('%.15g %.15g;', [real(z)'; imag(z)']); end; printf('\\n');\n"
    out = subprocess.run(["octave-cli", "-q"], input=script, capture_output=True, text=True, check=True).stdout
    return [[complex(*map(float, one.split())) for one in line.split(";") if one] for line in out.splitlines()]


def agree(zeros, A, B, C, D):
    """Each zero is a generalised eigenvalue of the system matrix."""
    pencil, E = np.block([[A, B], [C, D]]), np.zeros((len(A) + len(C), len(A) + len(C)))
    E[: len(A), : len(A)] = np.eye(len(A))
    values = eigvals(pencil, E)
    return all(min(abs(values - one)) < 2e-8 * (1e-6 + abs(one)) for one in zeros)


systems = [drawn(number) for number in range(200)]
print("sample time,A,B,C,D,zeros")
for (T, *matrices), zeros in zip(systems, by_octave(systems), strict=True):
    if matrices[1].shape[1] == matrices[2].shape[0]:
        assert agree(zeros, *matrices)
    print(f"{T:g}", *map(text, matrices), ";".join(f"{one.real:.15g} {one.imag:.15g}" for one in zeros), sep=",")
