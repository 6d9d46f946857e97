// The turns of all loops of a user's text, counted: after MOST_TURNS every one is left, and the first line kept where
// that happened. The conditions of the loops call it (app/loops.py).
const int MOST_TURNS = 30000;
int halfway_turns = 0, halfway_endless = 0;

bool halfway_goes_on(int line) {
    halfway_turns++;
    if (halfway_turns <= MOST_TURNS) return true;
    if (halfway_endless == 0) halfway_endless = line;
    return false;
}
