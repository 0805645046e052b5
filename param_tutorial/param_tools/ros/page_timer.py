"""``signal.setitimer`` for Python in a web page (Pyodide), which has none: its SIGALRM ends an endless loop.

Every fiftieth time that Python code jumps back or calls a function, Pyodide reads the number of a signal from index 0
of its interrupt buffer. It expects another thread to write there; this buffer, when read, looks at the clock instead.
Python code runs as fast as without it.
"""

import signal

_BUFFER = """({
    ringsAt: Infinity,
    periodMs: 0,
    get 0() {
        const now = performance.now();
        if (now < this.ringsAt) return 0;
        this.ringsAt = this.periodMs ? now + this.periodMs : Infinity;
        return %d;
    },
    set 0(_) {},  // Pyodide takes the number out
    arm(seconds, periodSec) {
        const now = performance.now();
        const leftSec = this.ringsAt === Infinity ? 0 : Math.max(this.ringsAt - now, 0.001) / 1000;
        this.ringsAt = seconds ? now + 1000 * seconds : Infinity;
        this.periodMs = 1000 * periodSec;
        return leftSec;
    },
})"""


def install() -> None:
    """Add ``setitimer`` to the module ``signal``; its only timer is ITIMER_REAL."""
    import pyodide_js
    from pyodide.code import run_js

    buffer = run_js(_BUFFER % signal.SIGALRM)
    arm, period_sec = buffer.arm, 0.0

    def setitimer(_which: int, seconds: float, interval: float = 0.0) -> tuple[float, float]:
        nonlocal period_sec
        before_sec, period_sec = period_sec, interval
        return arm(seconds, interval), before_sec

    signal.ITIMER_REAL, signal.setitimer = 0, setitimer
    pyodide_js.setInterruptBuffer(buffer)
