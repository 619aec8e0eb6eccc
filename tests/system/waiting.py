"""Waits for an effect of another program."""

import time

SECONDS_BETWEEN_LOOKS = 0.1


def wait_until(condition, seconds, what):
    """Polls the condition until it is true and returns its value; raises TimeoutError after `seconds`."""
    deadline = time.monotonic() + seconds
    while not (answer := condition()):
        if time.monotonic() > deadline:
            raise TimeoutError(f"not within {seconds} s: {what}")
        time.sleep(SECONDS_BETWEEN_LOOKS)
    return answer
