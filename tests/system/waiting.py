"""Waits for what another program brings about."""

import time

SECONDS_BETWEEN_LOOKS = 0.1


def wait_until(condition, seconds, what):
    """Looks again and again; returns what the condition returned, raises when it stays false."""
    deadline = time.monotonic() + seconds
    while not (answer := condition()):
        if time.monotonic() > deadline:
            raise TimeoutError(f"not within {seconds} s: {what}")
        time.sleep(SECONDS_BETWEEN_LOOKS)
    return answer
