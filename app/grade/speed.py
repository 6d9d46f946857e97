"""How long the solutions take at the points of an assignment: what a student's time is measured against.

They run as a student's text does, in the same kind of process on the same machine; for functions whose speed pays.
"""

from app.grade import texts
from app.grade.assignment import Assignment
from app.grade.intake import Submission
from app.grade.question import FILES, Question
from app.grade.sandbox import Limits
from app.grade.supervisor import answer


def solution_times(assignment: Assignment, asked: list[Question], limits: Limits, level: str) -> dict[str, float]:
    """Processor seconds by the question's id; nothing for an assignment in which no speed pays."""
    found: dict[str, float] = {}
    tasks = {task.function: task for task in assignment.tasks if task.runtime}
    for language in FILES:
        wanted = [q for q in asked if q.language == language and q.function in tasks]
        if wanted:
            parts = [(function, texts.solution(task, language)) for function, task in tasks.items()]
            submission = Submission("the solution", {FILES[language]: texts.joined(parts, language).encode()})
            found |= {reply.id: reply.seconds for reply in answer(submission, wanted, limits, level)
                      if not reply.verdict}
    return found
