"""Work that is not interrupted: signals come after it, and what a handler raises comes out as it is."""

import signal
import threading

import pytest
from hangs import send_one

from warpsample.host.arguments import naming_file
from warpsample.host.interrupts import uninterrupted
from warpsample.host.locks import making, once

pytestmark = pytest.mark.usefixtures("handlers_as_before")


def test_what_is_made_once_is_made_to_its_end():
    made = []

    @once
    def twice(x):
        send_one()
        made.append(x)
        return 2 * x

    with pytest.raises(KeyboardInterrupt):
        twice(3)
    assert made == [3]
    assert twice(3) == 6
    assert made == [3]
    free = []
    other = threading.Thread(target=lambda: free.append(making.acquire(blocking=False) and not making.release()))
    other.start()
    other.join()
    assert free == [True]


def test_a_users_handler_is_called_at_once_and_put_back():
    heard, stopped = [], []

    def handler(number, frame):
        heard.append(frame.f_code.co_name)
        if len(heard) > 1:
            raise TimeoutError(len(heard))

    def work():
        for _ in range(3):
            send_one()
        return len(heard), len(stopped)

    signal.signal(signal.SIGINT, handler)
    with pytest.raises(TimeoutError, match="2"):
        uninterrupted(work, stop=lambda: stopped.append(True))
    assert heard == ["send_one"] * 3
    assert stopped == [True] * 2
    assert signal.getsignal(signal.SIGINT) is handler
    heard.clear()
    assert uninterrupted(send_one) is None  # a handler that raises nothing interrupts nothing
    assert signal.getsignal(signal.SIGINT) is handler


def test_what_a_handler_raises_may_count_as_false():
    class Problems(Exception):
        def __len__(self):
            return 0

    def handler(*_):
        raise Problems

    signal.signal(signal.SIGINT, handler)
    with pytest.raises(Problems):
        uninterrupted(send_one)


def test_a_handler_that_another_one_has_set_stays():
    def handler(*_):
        signal.signal(signal.SIGINT, signal.SIG_IGN)

    signal.signal(signal.SIGINT, handler)
    uninterrupted(send_one)
    assert signal.getsignal(signal.SIGINT) == signal.SIG_IGN


def test_an_error_of_the_work_is_not_lost():
    def work():
        send_one()
        raise OSError("no room")

    with pytest.raises(KeyboardInterrupt) as interrupt:
        uninterrupted(work)
    assert str(interrupt.value.__context__) == "no room"


def test_a_deadline_is_no_damaged_file(tmp_path):
    file = tmp_path / "large.ply"
    file.write_text("ply")

    def late(*_):
        raise TimeoutError("my deadline")

    signal.signal(signal.SIGINT, late)
    with pytest.raises(TimeoutError, match="^my deadline$"), naming_file("path", file, "a mesh"):
        send_one()
    with pytest.raises(ValueError, match="line 4"), naming_file("path", file, "a mesh"):
        raise ValueError("line 4")
