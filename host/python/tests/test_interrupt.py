"""Ctrl-C ends every call that can take long."""

import subprocess
import sys

import pytest

CALLS = {
    "samples": "motion.at(np.linspace(0.0, 1.0, 20_000_000)).omega",
    "launches": "toytop.many(top, {'tilt': np.full(2_000_000, 0.3), 'spin': 150.0})",
    "tables": "many.at(0.0)",
    "columns": "many[:500].at(np.linspace(0.0, 1.0, 100_000)).columns()",
    "reference": "motion.reference(np.linspace(0.0, 1.0, 100_000))",
    "digits": "motion.reference_digits(np.linspace(0.0, 1.0, 100_000))",
    "closed form": "held.closed_form().at(np.linspace(0.0, 1.0, 1_000_000))",
    "events": "motion.events('tip_angle', 1.0, count=1_000_000)",
    "partials": "motion.partials(np.linspace(0.0, 1.0, 1_000_000))",
    "score": "toytop.score(motion, times, motion.at(times).quaternion)",
    "simulate": "toytop.simulate(motion, hertz=1e6)",
    "fit": "toytop.fit(toytop.simulate(motion, hertz=2e5), top)",
}

PROGRAM = """
import os, signal, sys, threading, time
import numpy as np
import toytop
top = toytop.Top.sliding(mass=0.05, com_height=0.03, transverse_inertia=3.0e-5, axial_inertia=2.0e-5)
held = toytop.Top.fixed(mass_moment=1.5e-3, transverse_inertia=7.5e-5, axial_inertia=2.0e-5).release(tilt=0.5, spin=200.0)
motion = top.release(tilt=0.35, spin=150.0)
motion.at(0.0)
times = np.linspace(0.0, 100.0, 2_000_000)
many = toytop.many(top, {"tilt": np.linspace(0.1, 1.0, 20_000), "spin": 150.0})
# a shell that starts the tests in the background makes them ignore Ctrl-C
signal.signal(signal.SIGINT, signal.default_int_handler)
sent = []
def interrupt():
    sent.append(time.process_time())
    os.kill(os.getpid(), signal.SIGINT)
timer = threading.Timer(0.4, interrupt)
timer.start()
try:
    CALL
    print("ended before")
except KeyboardInterrupt:
    print(time.process_time() - sent[0])
sys.stdout.flush()
os._exit(0)
"""


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS.keys())
def test_a_call_is_interrupted(call: str) -> None:
    run = [sys.executable, "-c", PROGRAM.replace("CALL", call)]
    processor_time = float(subprocess.run(run, capture_output=True, text=True, check=True, timeout=120).stdout)
    # s; uninterrupted, each call takes longer than this
    assert processor_time < 1.0
