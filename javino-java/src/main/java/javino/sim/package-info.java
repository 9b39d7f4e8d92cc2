/**
 * Boards without hardware: programs in place of boards, lines in memory, and recordings of a line.
 *
 * <p>{@link javino.sim.SimulatedBoards} makes a {@link javino.sim.SimulatedBoard} available as the port {@code sim:NAME}. A
 * {@link javino.sim.Sketch} is a board made of two functions. {@code FakeBoard}, in the library {@code argo-testkit}, is a board for
 * tests. {@link javino.sim.ReplayBoard} sends the messages of a {@link javino.sim.LineRecording}.
 */
package javino.sim;
