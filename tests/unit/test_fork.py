"""A process may be forked while one of its threads solves: nothing of the solver stays locked in it."""

import os
import threading
import time
import warnings

import pytest
from methods import POINT

import thirdbody as tb

FORKS = 100
PATIENCE = 20.0  # [s] for a child that takes some milliseconds


def ends_well(child):
    """Whether the process ends by itself, and with success; it is ended if it does not."""
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        ended, status = os.waitpid(child, os.WNOHANG)
        if ended:
            return status == 0
        time.sleep(0.001)
    os.kill(child, 9)
    os.waitpid(child, 0)
    return False


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system has no fork")
def test_a_child_that_was_forked_while_a_thread_solved_can_solve(parameters):
    enough = threading.Event()

    def keep_solving():
        while not enough.is_set():
            tb.solve(**POINT, parameters=parameters)

    thread = threading.Thread(target=keep_solving)
    thread.start()
    try:
        for _ in range(FORKS):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DeprecationWarning)  # of forks among threads
                child = os.fork()
            if child == 0:
                try:
                    tb.solve(**POINT, parameters=parameters)
                    os._exit(0)
                finally:
                    os._exit(1)
            assert ends_well(child)
    finally:
        enough.set()
        thread.join()
