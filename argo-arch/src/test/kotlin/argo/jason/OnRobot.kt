package argo.jason

import javino.sim.FakeBoard

/** Runs [use] with a board plugged in as `sim:robot`, whose sensors say [percepts], and a Jason for the agents on it. */
fun onRobot(percepts: String, use: (FakeBoard, TestMas) -> Unit) = FakeBoard.plugIn("robot").use { board ->
    board.lenient()
    board.whenAsked("getPercepts").answer(percepts)
    TestMas().use { mas -> use(board, mas) }
}
