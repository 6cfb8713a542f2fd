#!/usr/bin/python3
# Draws loops L = N/D exp(-s delay) and writes their margins under negative feedback beside them. Without a delay
# crossings and extremes are roots of polynomials, by mpmath with 40 digits. With a delay, and for sampled loops,
# they come from a dense search with scipy. Written once with Debian's mpmath 1.2.1 and scipy 1.10.1:
#   /usr/bin/python3 loops.py > loops.csv
import mpmath as mp
import numpy as np
from scipy.optimize import brentq, minimize_scalar

mp.mp.dps = 40
rng = np.random.default_rng(36)


def in_axis(p):
    """Real and imaginary part of p(jw) as polynomials in w, highest power first."""
    n = len(p) - 1
    turned = [mp.mpf(c) * mp.mpc(0, 1) ** (n - k) for k, c in enumerate(p)]
    return [c.real for c in turned], [c.imag for c in turned]


def times(a, b):
    out = [mp.mpf(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            out[i + j] += x * y
    return out


def plus(a, b, factor=1):
    n = max(len(a), len(b))
    return [x + factor * y for x, y in zip([mp.mpf(0)] * (n - len(a)) + list(a), [mp.mpf(0)] * (n - len(b)) + list(b))]


def slope(p):
    return [c * (len(p) - 1 - k) for k, c in enumerate(p[:-1])] or [mp.mpf(0)]


def positive_roots(p):
    p = list(p)
    while p and p[0] == 0:
        p.pop(0)
    while p and p[-1] == 0:
        p.pop()
    if len(p) < 2:
        return []
    roots = mp.polyroots(p, maxsteps=500, extraprec=300)
    return sorted({mp.nstr(r.real, 25): r.real for r in roots if abs(r.imag) < 1e-15 * abs(r) and r.real > 0}.values())


def of_rational(N, D):
    (a, b), (c, d) = in_axis(N), in_axis(D)

    def square(re, im):
        return plus(times(re, re), times(im, im))

    def L(w):
        return mp.polyval(N, mp.mpc(0, w)) / mp.polyval(D, mp.mpc(0, w))

    gain = [(w, -1 / L(w).real) for w in positive_roots(plus(times(b, c), times(a, d), -1)) if L(w).real < 0]
    phase = [(w, mp.arg(-L(w))) for w in positive_roots(plus(square(a, b), square(c, d), -1))]
    P, Q = square(plus(a, c), plus(b, d)), square(c, d)
    places = positive_roots(plus(times(slope(P), Q), times(P, slope(Q)), -1))
    sizes = [(abs(1 + L(w)), w) for w in places]
    if D[-1] != 0:
        start = mp.mpf(N[-1]) / D[-1]
        sizes.append((abs(1 + start), 0))
        if start < 0:
            gain.insert(0, (0, -1 / start))
    direct = mp.mpf(N[0]) / D[0] if len(N) == len(D) else mp.mpf(0)
    sizes.append((abs(1 + direct), mp.inf))
    if direct < 0:
        gain.append((mp.inf, -1 / direct))
    closed = mp.polyroots(plus(N, D), maxsteps=500, extraprec=300) if len(D) > 1 else []
    return gain, phase, min(sizes), all(r.real < 0 for r in closed)


def of_search(L, grid, stable):
    """Signs on a dense grid, refined; for a delay and for sampled loops."""
    values = L(grid)
    gain, phase = [], []
    for k in np.flatnonzero(np.diff(np.sign(values.imag))):
        w = brentq(lambda x: L(x).imag, grid[k], grid[k + 1], xtol=1e-300, rtol=1e-15)
        if L(w).real < 0 and abs(L(w).imag) < 1e-6 * abs(L(w)):
            gain.append((w, -1 / L(w).real))
    for k in np.flatnonzero(np.diff(np.sign(abs(values) - 1))):
        w = brentq(lambda x: abs(L(x)) - 1, grid[k], grid[k + 1], xtol=1e-300, rtol=1e-15)
        phase.append((w, np.angle(-L(w))))
    if values[0].real < 0 and abs(values[0].imag) < 1e-3 * abs(values[0]):  # no pole at rest
        gain.insert(0, (0, -1 / values[0].real))
    size = abs(1 + values)
    dips = np.flatnonzero((size[1:-1] <= size[:-2]) & (size[1:-1] <= size[2:]) & (size[1:-1] < 1.5 * size.min())) + 1
    least = [(size[-1], grid[-1]), (abs(1 + values[0].real), 0)]
    for k in dips:
        between = (grid[k - 1], grid[k + 1])
        best = minimize_scalar(lambda x: abs(1 + L(x)), bounds=between, method="bounded", options={"xatol": 1e-14})
        least.append((best.fun, best.x))
    return gain, phase, min(least), stable


def of_delay(N, D, delay):
    def L(w):
        return np.polyval(N, 1j * w) / np.polyval(D, 1j * w) * np.exp(-1j * w * delay)

    grid = np.unique(np.concatenate([np.geomspace(1e-5, 1e4, 400001), np.arange(1, 200001) * 2e-3 / delay]))
    grid = grid[grid * delay < 400]
    axis = np.linspace(0, 4000, 4000001)
    values = np.polyval(D, 1j * axis) + np.polyval(N, 1j * axis) * np.exp(-1j * axis * delay)
    angle = np.sum(np.angle(values[1:] / values[:-1]))  # criterion of Mikhailov
    gain, *others = of_search(L, grid, bool(round((len(D) - 1) / 2 - angle / np.pi) == 0))
    return [one for one in gain if one[0] > 0 or D[-1] != 0], *others


def of_sampled(N, D, T):
    def L(w):
        return np.polyval(N, np.exp(1j * w * T)) / np.polyval(D, np.exp(1j * w * T))

    grid = np.unique(np.concatenate([np.geomspace(1e-6, np.pi, 200001), np.linspace(1e-6, np.pi, 400001)])) / T
    gain, phase, least, stable = of_search(L, grid[:-1], bool(max(abs(np.roots(np.polyadd(N, D)))) < 1))
    end = L(np.pi / T).real
    if end < 0:
        gain.append((np.pi / T, -1 / end))
    return gain, phase, min(least, (abs(1 + end), np.pi / T)), stable


def four(p):
    return [float(f"{c:.4g}") for c in np.atleast_1d(p)]


def drawn_roots(count, unstable, rest=True):
    roots = []
    while len(roots) < count:
        size = 10 ** rng.uniform(-1.5, 1.5) * (1 if unstable and rng.random() < 0.3 else -1)
        if count - len(roots) > 1 and rng.random() < 0.5:
            ratio = 10 ** rng.uniform(-2.5, 0)
            roots += [size * (ratio + 1j), size * (ratio - 1j)]
        elif rest and rng.random() < 0.25 and not unstable:
            roots.append(0.0)
        else:
            roots.append(size)
    return roots


def drawn(number):
    n = int(rng.integers(1, 5))
    m = int(rng.integers(0, n + 1)) if number < 30 else int(rng.integers(0, n))
    D = np.real(np.poly(drawn_roots(n, number % 5 == 4)))
    N = np.real(np.atleast_1d(np.poly(drawn_roots(m, number % 3 == 2, False))))
    w = 10 ** rng.uniform(-1, 1)
    N = N * abs(np.polyval(D, 1j * w) / np.polyval(N, 1j * w)) * rng.choice([1, 1, 1, -1])
    delay = float(f"{10 ** rng.uniform(-1.5, 0.7):.3g}") if number >= 40 else 0.0
    while delay and abs(np.polyval(N, 300j / delay) / np.polyval(D, 300j / delay)) > 0.5:
        delay = float(f"{0.3 * delay:.3g}")  # so that the search reaches all that matters
    if 30 <= number < 40:
        poles = rng.uniform(-0.9, 0.99, n)
        D, N = np.poly(poles), np.atleast_1d(np.poly(rng.uniform(-0.9, 0.9, n - 1))) * rng.uniform(0.05, 1.5)
        return four(N), four(D), 0.0, 0.1
    return four(N), four(D), delay, 0.0


def pairs(all):
    return ";".join(f"{float(w):.13g} {float(m):.13g}" for w, m in all)


known = [([1000], [1, 0], 0.0, 0.0), ([0.5], [1, -1], 0.0, 0.0), ([1e4], [1, 0.01, 1], 0.0, 0.0), ([5], [1, 3, 3, 1], 0.0, 0.0)]
known += [([2, 1], [1, 1], 0.0, 0.0), ([4, 0.4, 4], [1, 0.002, 1], 0.0, 0.0), ([1], [1, 0.001, 1], 0.0, 0.0)]
print("numerator,denominator,delay,sample time,gain margins,phase margins,modulus,its frequency,stable")
for N, D, delay, T in known + [drawn(number) for number in range(60)]:
    gain, phase, least, stable = of_sampled(N, D, T) if T else of_delay(N, D, delay) if delay else of_rational(N, D)
    row = [" ".join(map(repr, map(float, p))) for p in (N, D)]
    ends = [f"{float(least[0]):.13g}", f"{float(least[1]):.13g}", int(stable)]
    print(*row, f"{delay:g}", f"{T:g}", pairs(gain), pairs(phase), *ends, sep=",")
