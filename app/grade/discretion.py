"""What may be told of a failure: a student's process chooses its words, and could spell out the points it was sent.

So the words of a failed text are taken from a process that is sent the visible points alone; what fails only among the
hidden ones is told in a sentence of ours. It costs a right answer nothing.
"""

from dataclasses import replace

from app.grade.intake import Submission
from app.grade.question import Question, Reply
from app.grade.sandbox import Limits
from app.grade.supervisor import answer

ITS_OWN = ("runtime_error", "missing", "memory", "forbidden", "compile_error")  # verdicts whose words it may choose
OURS = "it fails among the hidden points; what it says there is not passed on, since it could hold them"


def answered(submission: Submission, questions: list[Question], limits: Limits, granted: str) -> list[Reply]:
    """A reply to each question, visible and hidden ones, in their order."""
    replies = answer(submission, questions, limits, granted)
    asked = {question.id: question for question in questions}
    loud = [reply.id for reply in replies if reply.verdict in ITS_OWN and asked[reply.id].language == "python"]
    if not loud or not any(question.hidden for question in questions):
        return replies
    shown = [question for question in questions if question.language == "python" and not question.hidden]
    words = {(asked[reply.id].function, reply.verdict): reply.said
             for reply in answer(submission, shown, limits, granted)}
    return [replace(reply, said=words.get((asked[reply.id].function, reply.verdict), OURS)) if reply.id in loud
            else reply for reply in replies]
