"""Clocks, timers, and sleeping by a clock: rcl's time.c and timer.c.

A clock of ROS time is the system's, until somebody sets its time (``use_sim_time``); then it may jump, and tells so.
"""

import time
from collections.abc import Callable
from typing import Any, NamedTuple

from param_tools.rcl_in_python.enums import ClockChange, ClockType
from param_tools.rcl_in_python.exceptions import RCLError
from param_tools.rcl_in_python.waiting import Destroyable, changed, check_context, wait_until


class rcl_time_point_t:
    """A point of time on a kind of clock."""

    def __init__(self, nanoseconds: int, clock_type: int):
        if not -2**63 <= nanoseconds < 2**63:
            raise TypeError(f'{nanoseconds} ns do not fit into 64 bits')
        self.nanoseconds = nanoseconds
        self.clock_type = ClockType(clock_type)


class _Jump(NamedTuple):
    change: ClockChange
    delta: int
    """By how many ns; negative for a jump back."""


class _JumpCallback(NamedTuple):
    owner: Any
    before: Callable[[_Jump], object]
    after: Callable[[_Jump], object]
    on_clock_change: bool
    min_forward: int
    min_backward: int

    def is_for(self, jump: _Jump) -> bool:
        """True if the jump is one that the callback wants to hear of."""
        if jump.change in (ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED):
            return self.on_clock_change
        return (0 < self.min_forward <= jump.delta) or (self.min_backward < 0 and jump.delta <= self.min_backward)


class Clock(Destroyable):
    """A clock of one of three kinds."""

    def __init__(self, clock_type: int):
        super().__init__()
        try:
            self.type = ClockType(int(clock_type))
        except ValueError:
            raise RCLError('failed to initialize clock: error not set') from None
        self.is_overridden = False
        self._time_ns = 0
        self._callbacks: list[_JumpCallback] = []

    def now_ns(self) -> int:
        if self.is_overridden:
            return self._time_ns
        return time.monotonic_ns() if self.type is ClockType.STEADY_TIME else time.time_ns()

    def get_now(self) -> rcl_time_point_t:
        if self.type is ClockType.UNINITIALIZED:
            raise RCLError('failed to get current clock value: '
                           'Clock is not initialized or does not have get_now registered.')
        return rcl_time_point_t(self.now_ns(), self.type)

    def get_ros_time_override_is_enabled(self) -> bool:
        self._check_ros_time('get ROS time override status', 'query override state')
        return self.is_overridden

    def set_ros_time_override_is_enabled(self, enabled: bool) -> None:
        self._check_ros_time('set ROS time override', 'enable override' if enabled else 'disable override')
        if enabled != self.is_overridden:
            change = ClockChange.ROS_TIME_ACTIVATED if enabled else ClockChange.ROS_TIME_DEACTIVATED
            self._jump(_Jump(change, 0), lambda: setattr(self, 'is_overridden', enabled))

    def set_ros_time_override(self, time_point: rcl_time_point_t) -> None:
        self._check_ros_time('set ROS time override', 'set time override')
        set_time = lambda: setattr(self, '_time_ns', time_point.nanoseconds)  # noqa: E731
        if self.is_overridden:
            self._jump(_Jump(ClockChange.ROS_TIME_NO_CHANGE, time_point.nanoseconds - self._time_ns), set_time)
        else:
            set_time()

    def _check_ros_time(self, what: str, which: str) -> None:
        if self.type is not ClockType.ROS_TIME:
            raise RCLError(f'failed to {what}: Clock is not of type RCL_ROS_TIME, cannot {which}.')

    def _jump(self, jump: _Jump, do: Callable[[], object]) -> None:
        """Change the time, and tell those who want to know, before and after; the first exception ends it."""
        concerned = [each for each in self._callbacks if each.is_for(jump)]
        try:
            for callback in concerned:
                callback.before(jump)
        finally:
            with changed:
                do()
                changed.notify_all()
        for callback in concerned:
            callback.after(jump)

    def add_callback(self, callback: _JumpCallback) -> None:
        self._callbacks.append(callback)

    def add_clock_callback(self, handle: Any, on_clock_change: bool, min_forward: int, min_backward: int) -> None:
        if any(each.owner is handle for each in self._callbacks):
            raise RCLError('failed to add time jump callback: callback/user_data are already added to this clock')

        def before(_: _Jump) -> None:
            if handle._pre_callback is not None:
                handle._pre_callback()

        def after(jump: _Jump) -> None:
            if handle._post_callback is not None:
                handle._post_callback({'clock_change': jump.change, 'delta': jump.delta})

        self.add_callback(_JumpCallback(handle, before, after, on_clock_change, min_forward, min_backward))

    def remove_clock_callback(self, owner: Any) -> None:
        kept = [each for each in self._callbacks if each.owner is not owner]
        if len(kept) == len(self._callbacks):
            raise RCLError('failed to remove time jump callback: jump callback was not found')
        self._callbacks = kept


class ClockEvent:
    """What ``Clock.sleep_until`` waits for."""

    def __init__(self) -> None:
        self._is_set = False

    def wait_until_steady(self, clock: Clock, until: rcl_time_point_t) -> None:
        end = time.monotonic_ns() + until.nanoseconds - clock.now_ns()
        wait_until(self.is_set, lambda: end)

    wait_until_system = wait_until_steady

    def wait_until_ros(self, clock: Clock, until: rcl_time_point_t) -> None:
        if clock.is_overridden:
            wait_until(self.is_set, lambda: None)
        else:
            self.wait_until_steady(clock, until)

    def is_set(self) -> bool:
        return self._is_set

    def set(self) -> None:
        with changed:
            self._is_set = True
            changed.notify_all()

    def clear(self) -> None:
        self._is_set = False


class Timer(Destroyable):
    """Something to be called every so often, by a clock."""

    def __init__(self, clock: Clock, context: Any, period_ns: int, autostart: bool):
        if period_ns < 0:
            raise RCLError('failed to create timer: timer period must be non-negative')
        check_context(context, 'failed to create timer')
        super().__init__()
        self._clock, self._period = clock, period_ns
        self._last = clock.now_ns()
        self._next = self._last + period_ns
        self._is_canceled = not autostart
        # What was left of the period when ROS time came or went.
        self._remaining = 0
        if clock.type is ClockType.ROS_TIME:
            clock.add_callback(_JumpCallback(self.pointer, self._before_jump, self._after_jump, True, 1, -1))

    def _destroy(self) -> None:
        if self._clock.type is ClockType.ROS_TIME:
            self._clock.remove_clock_callback(self.pointer)

    def _before_jump(self, jump: _Jump) -> None:
        if jump.change is not ClockChange.ROS_TIME_NO_CHANGE and (now := self._clock.now_ns()):
            self._remaining = self._next - now

    def _after_jump(self, jump: _Jump) -> None:
        now = self._clock.now_ns()
        if jump.change is not ClockChange.ROS_TIME_NO_CHANGE:
            if now and self._remaining:
                self._last, self._next = now - self._remaining, now - self._remaining + self._period
                self._remaining = 0
        elif now < self._last:
            self._last, self._next = now, now + self._period

    def is_ready(self) -> bool:
        return not self._is_canceled and self._next <= self._clock.now_ns()

    def due_ns(self) -> int | None:
        """Return when it will be ready by itself, in ns of the steady clock; None if that cannot be told."""
        if self._is_canceled or self._clock.is_overridden:
            return None
        return time.monotonic_ns() + self._next - self._clock.now_ns()

    def is_timer_ready(self) -> bool:
        return self.is_ready()

    def call_timer(self) -> None:
        """Note that it has been called, and when it is due next: the first time of its beat after now."""
        if self._is_canceled:
            raise RCLError('failed to call timer: timer is canceled')
        self._last = now = self._clock.now_ns()
        self._next += self._period
        if self._next <= now:
            self._next = now + self._period - (now - self._next) % self._period if self._period else now

    def reset_timer(self) -> None:
        with changed:
            self._next = self._clock.now_ns() + self._period
            self._is_canceled = False
            changed.notify_all()

    def cancel_timer(self) -> None:
        self._is_canceled = True

    def is_timer_canceled(self) -> bool:
        return self._is_canceled

    def change_timer_period(self, period_ns: int) -> None:
        self._period = period_ns

    def get_timer_period(self) -> int:
        return self._period

    def time_until_next_call(self) -> int | None:
        return None if self._is_canceled else self._next - self._clock.now_ns()

    def time_since_last_call(self) -> int:
        return self._clock.now_ns() - self._last
