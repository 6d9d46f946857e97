"""Where submissions are graded: threads here that supervise processes, or workers of a Dask cluster.

Both have four methods: submit, as_completed, cancel, close. A task gets and returns a small dict; a student's text
never runs in a worker itself. A task may be run twice, on a cluster, and gives the same bytes both times.
"""

import queue
from collections.abc import Callable, Iterator
from concurrent import futures
from typing import Any, Protocol

from app.problem import Problem

RESOURCE = "GRADER"
PATIENCE = 900.0  # s without a single result after which the wait is over
START = "dask worker ADDRESS --nworkers 1 --nthreads 2 --resources GRADER=2"


class Executor(Protocol):
    slots: int

    def submit(self, task: Callable[[dict], dict], job: dict) -> Any: ...

    def as_completed(self) -> Iterator[tuple[dict, dict | None]]: ...

    def cancel(self) -> None: ...

    def close(self) -> None: ...


class Waiting:
    """What both have: futures and their jobs; a failed task is None, never an exception."""

    def __init__(self, pool: futures.Executor, slots: int, patience: float = PATIENCE) -> None:
        self.pool, self.slots, self.patience = pool, slots, patience
        self.jobs: dict[futures.Future, dict] = {}
        self.finished: queue.SimpleQueue[futures.Future] = queue.SimpleQueue()

    def submit(self, task: Callable[[dict], dict], job: dict) -> futures.Future:
        future = self.pool.submit(task, job)
        self.jobs[future] = job
        future.add_done_callback(self.finished.put)
        return future

    def as_completed(self) -> Iterator[tuple[dict, dict | None]]:
        """Jobs with their results as they come, those submitted meanwhile too; None where the task itself was lost."""
        while self.jobs:
            try:
                future = self.finished.get(timeout=self.patience)
            except queue.Empty:  # every wait has an end: a cluster that lost its workers
                for job in [self.jobs.pop(future) for future in list(self.jobs)]:
                    yield job, None
                return
            if future in self.jobs and not future.cancelled():
                yield self.jobs.pop(future), None if future.exception() else future.result()
            else:
                self.jobs.pop(future, None)

    def cancel(self) -> None:
        """Nothing new is begun; what runs goes on to its end."""
        for future in list(self.jobs):
            if future.cancel():
                self.jobs.pop(future)

    def close(self) -> None:
        self.cancel()
        self.pool.shutdown(wait=True)


class LocalExecutor(Waiting):
    """Threads, one a processor core; each waits for the processes it supervises, so a pool of processes would only
    add one that can break."""

    def __init__(self, jobs: int) -> None:
        super().__init__(futures.ThreadPoolExecutor(jobs, thread_name_prefix="grader"), jobs)


class DaskExecutor(Waiting):
    """The workers of a cluster that offer the resource GRADER."""

    def __init__(self, address: str, patience: float = PATIENCE) -> None:
        try:
            from distributed import Client
        except ImportError:
            raise Problem("--scheduler needs the extra cluster: pip install 'halfway[cluster]'.") from None
        try:
            self.client = Client(address, timeout=5, set_as_default=False)
        except (OSError, ValueError, TimeoutError) as error:
            raise Problem(f"there is no Dask scheduler at {address} ({str(error)[:120]}).") from None
        workers = self.client.scheduler_info(n_workers=-1)["workers"].values()
        slots = int(sum(worker.get("resources", {}).get(RESOURCE, 0) for worker in workers))
        if not slots:
            self.client.close()
            raise Problem(f"no worker at {address} offers {RESOURCE}; start one with: "
                          f"{START.replace('ADDRESS', address)}")
        pool = self.client.get_executor(pure=False, retries=0, resources={RESOURCE: 1})
        super().__init__(pool, slots, patience)

    def close(self) -> None:
        super().close()
        self.client.close()
