/**
 * Boards without hardware: programs that behave as a board does, lines in memory, and recordings of a line.
 *
 * <p>{@link javino.sim.SimulatedBoards} makes a {@link javino.sim.SimulatedBoard} available as the port {@code sim:NAME};
 * a {@link javino.sim.Sketch} is one of two functions; {@code FakeBoard}, in the library {@code argo-testkit}, is one for tests.
 * {@link javino.sim.ReplayBoard} sends what a {@link javino.sim.LineRecording} holds.
 */
package javino.sim;
