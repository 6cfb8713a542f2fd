# the loop of 113 as one matrix: outer PI every 5 ms, inner PI every 1 ms, motor exact between (scipy expm)
import numpy as np
from scipy.linalg import expm
R,L,J,kt,b=1.2,3e-3,4e-4,0.08,2e-4
kpc,kic,kps,kis=2.0,600.0,0.5,4.0
A=np.array([[-R/L,-kt/L],[kt/J,-b/J]]); B=np.array([[1/L],[0]])
E=expm(np.block([[A,B],[np.zeros((1,3))]])*1e-3); Ad,Bd=E[:2,:2],E[:2,2:]
# z = [i, w, Ic, Is, hold]; input r added to what returns: open at speed error? loop: opened at 'error' (speed error)
def period(z,e):           # e: speed error, constant over 5 ms
    i,w,Ic,Is=z
    cmd=kps*e+Is; Is=Is+kis*5e-3*e
    x=np.array([i,w])
    for _ in range(5):
        ec=cmd-x[0]; u=kpc*ec+Ic; Ic=Ic+kic*1e-3*ec
        x=Ad@x+Bd[:,0]*u
    return np.array([x[0],x[1],Ic,Is])
n=4; AA=np.column_stack([period(np.eye(n)[k],0.) for k in range(n)]); BB=period(np.zeros(n),1.)
C=np.array([0,-1,0,0.])     # what returns: error = 0 - w
print("eig",np.sort_complex(np.linalg.eigvals(AA)))
Lf=lambda w: -(C@np.linalg.solve(np.exp(1j*w*5e-3)*np.eye(n)-AA,BB))
from scipy.optimize import brentq
g=lambda w: np.log(abs(Lf(w)))
ws=np.logspace(-1,np.log10(np.pi/5e-3),4000)
for a,b_ in zip(ws,ws[1:]):
    if g(a)*g(b_)<0:
        w=brentq(g,a,b_,xtol=1e-13); print("crossover",repr(w),"pm",repr(np.degrees(np.angle(-Lf(w)))))
    if Lf(a).imag*Lf(b_).imag<0 and Lf(a).real<0:
        w=brentq(lambda w:Lf(w).imag,a,b_,xtol=1e-13); print("phase cross",repr(w),"gm",repr(-1/Lf(w).real))
print("at nyquist", Lf(np.pi/5e-3), "closed", np.abs(np.linalg.eigvals(AA+np.outer(BB,C))))
