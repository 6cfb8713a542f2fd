# The loop of example 113 as one matrix: outer PI every 5 ms, inner PI every 1 ms, the motor exact between them (expm of SciPy).
import numpy as np
from scipy.linalg import expm
from scipy.optimize import brentq

R, L, J, kt, b = 1.2, 3e-3, 4e-4, 0.08, 2e-4
kpc, kic, kps, kis = 2.0, 600.0, 0.5, 4.0
A = np.array([[-R / L, -kt / L], [kt / J, -b / J]])
B = np.array([[1 / L], [0]])
E = expm(np.block([[A, B], [np.zeros((1, 3))]]) * 1e-3)
Ad, Bd = E[:2, :2], E[:2, 2:]


def period(z, e):
    """The state [current, speed, inner integral, outer integral] after 5 ms with a constant speed error."""
    i, w, Ic, Is = z
    cmd = kps * e + Is
    Is = Is + kis * 5e-3 * e
    x = np.array([i, w])
    for _ in range(5):
        ec = cmd - x[0]
        u = kpc * ec + Ic
        Ic = Ic + kic * 1e-3 * ec
        x = Ad @ x + Bd[:, 0] * u
    return np.array([x[0], x[1], Ic, Is])


n = 4
AA = np.column_stack([period(np.eye(n)[k], 0.) for k in range(n)])
BB = period(np.zeros(n), 1.)
C = np.array([0, -1, 0, 0.])  # the error that returns: 0 - w
print("eig", np.sort_complex(np.linalg.eigvals(AA)))


def loop(w):
    """The frequency response of the loop, opened at the speed error."""
    return -(C @ np.linalg.solve(np.exp(1j * w * 5e-3) * np.eye(n) - AA, BB))


def gain(w):
    return np.log(abs(loop(w)))


ws = np.logspace(-1, np.log10(np.pi / 5e-3), 4000)
for low, high in zip(ws, ws[1:]):
    if gain(low) * gain(high) < 0:
        w = brentq(gain, low, high, xtol=1e-13)
        print("crossover", repr(w), "pm", repr(np.degrees(np.angle(-loop(w)))))
    if loop(low).imag * loop(high).imag < 0 and loop(low).real < 0:
        w = brentq(lambda w: loop(w).imag, low, high, xtol=1e-13)
        print("phase cross", repr(w), "gm", repr(-1 / loop(w).real))
print("at nyquist", loop(np.pi / 5e-3), "closed", np.abs(np.linalg.eigvals(AA + np.outer(BB, C))))
