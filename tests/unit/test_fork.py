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


def forks_that_end_well(solved_by_a_thread, solved_by_a_child, forks):
    """How many of so many children end well, forked while a thread solves again and again."""
    enough = threading.Event()

    def keep_solving():
        while not enough.is_set():
            tb.solve(**solved_by_a_thread)

    thread = threading.Thread(target=keep_solving)
    thread.start()
    try:
        for number in range(forks):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DeprecationWarning)  # of forks among threads
                child = os.fork()
            if child == 0:
                try:
                    for given in solved_by_a_child:
                        tb.solve(**given)
                    os._exit(0)
                finally:
                    os._exit(1)
            if not ends_well(child):
                return number
    finally:
        enough.set()
        thread.join()
    return forks


FORK = pytest.mark.skipif(not hasattr(os, "fork"), reason="the system has no fork")


@FORK
def test_a_child_that_was_forked_while_a_thread_solved_can_solve(parameters):
    given = POINT | {"parameters": parameters}
    assert forks_that_end_well(given, [given], FORKS) == FORKS
