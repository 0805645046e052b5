"""Chapters recorded in several processes at once, none of which outlives the build, however that ends."""

import concurrent.futures
import contextlib
import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator
from pathlib import Path
from types import FrameType

from param_tutorial.site.recording.recorded import Recordings
from param_tutorial.site.recording.run import cells_with_widgets, read_notebook, record_chapter


def record_all(paths: list[Path], processes: int) -> Iterator[tuple[Path, Recordings]]:
    """Run and record chapters, and yield each as soon as it is done.

    :raises ChapterError: a chapter fails, or does not do what is stored in it.
    """
    # Spawned, since a fork takes over locks and threads of the libraries that are loaded here.
    pool = concurrent.futures.ProcessPoolExecutor(processes, multiprocessing.get_context('spawn'), _begin)
    try:
        with _without_interrupts():
            running = {pool.submit(record_chapter, path): path for path in sorted(paths, key=_length, reverse=True)}
        for future in concurrent.futures.as_completed(running):
            yield running[future], future.result()
    except BaseException:
        for worker in multiprocessing.active_children():
            worker.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


def _length(path: Path) -> tuple[int, str]:
    """Return what puts first the chapters that take longest: many views, and the later ones, which do more."""
    return max(2, sum(1 for _ in cells_with_widgets(read_notebook(path)))), path.name


@contextlib.contextmanager
def _without_interrupts() -> Iterator[None]:
    """Let the processes that start now ignore Ctrl+C from their first moment: this one ends them.

    What is pressed meanwhile is not lost.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    pressed: list[int] = []
    before = signal.signal(signal.SIGINT, lambda number, _: pressed.append(number))
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGINT])
        signal.signal(signal.SIGINT, before)
        if pressed:
            raise KeyboardInterrupt


def _begin() -> None:
    """Prepare a worker: it ends when it is told to, and when the build is gone, and its kernels with it."""
    # A handler and not SIG_IGN, which the kernels and what they start would inherit.
    signal.signal(signal.SIGINT, lambda *_: None)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGINT])
    signal.signal(signal.SIGTERM, _end)
    threading.Thread(target=_end_with_the_build, name='waits for the end of the build', daemon=True).start()


def _end_with_the_build() -> None:
    if build := multiprocessing.parent_process():
        build.join()
        _end()


def _end(_: int = 0, __: FrameType | None = None) -> None:
    # The kernels see that it is gone, and end.
    os._exit(1)
