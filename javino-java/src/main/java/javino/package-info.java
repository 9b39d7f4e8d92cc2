/**
 * Messages between a program and a microcontroller board, over a serial line, in versions 1 and 2 of the Javino protocol.
 *
 * <p>Programs use {@link javino.link.Link}, which opens a port for one owner, asks the board until it answers, and exchanges messages at
 * the pace of the line. {@link javino.link.Javino} is the classic interface on top of it. Below it a {@link javino.Transport} moves bytes,
 * and {@link javino.Frame} and {@link javino.FrameDecoder} make messages of them:
 *
 * <pre>
 * board --bytes--&gt; Transport --&gt; FrameDecoder --&gt; Link --messages--&gt; program
 * board &lt;--bytes-- Transport &lt;-- Frame &lt;-------- Link &lt;--messages-- program
 * </pre>
 *
 * <p>{@link javino.Transports} finds a transport by the port's name: a serial device ({@code ttyACM0}, {@code /dev/pts/3}, {@code COM8}), a
 * serial device by its USB identity ({@code usb:2341:0043}), a board on the network ({@code tcp://robot:4000}), a
 * {@link javino.sim.SimulatedBoard} of this program ({@code sim:robot}), or a kind of port that a {@link javino.TransportProvider} adds.
 * {@code javino.sim.FakeBoard}, in the library {@code argo-testkit}, is a simulated board for tests.
 *
 * <table>
 *   <caption>The exceptions. All are {@link javino.PortException}s, which know the port's name</caption>
 *   <tr><th>exception</th><th>thrown when</th><th>by</th><th>then the port</th></tr>
 *   <tr><td>{@link javino.NoSuchPortException}</td><td>there is no such port or scheme; lists the present ones</td><td>opening</td>
 *     <td>is not open</td></tr>
 *   <tr><td>{@link javino.PortBusyException}</td><td>it is open already: {@link javino.PortBusyException#owner()}</td><td>opening</td>
 *     <td>is not open</td></tr>
 *   <tr><td>{@link javino.PortPermissionException}</td><td>this user may not open it; says how to change that</td><td>opening</td>
 *     <td>is not open</td></tr>
 *   <tr><td>{@link javino.PortFaultException}</td><td>the driver refuses for another reason; carries its code</td><td>opening</td>
 *     <td>is not open</td></tr>
 *   <tr><td>{@link javino.PortTimeoutException}</td><td>an operation was not done in time</td><td>reading, writing</td>
 *     <td>stays usable</td></tr>
 *   <tr><td>{@link javino.ActionRefusedException}</td><td>a version 2 board does not know the action, or refuses it</td><td>sending</td>
 *     <td>stays usable</td></tr>
 *   <tr><td>{@link javino.ActionUnconfirmedException}</td><td>a version 2 board did not say that it acted</td><td>sending</td>
 *     <td>stays usable</td></tr>
 *   <tr><td>{@link javino.CommandWithdrawnException}</td><td>a command's time was over before it began to go out</td><td>sending</td>
 *     <td>stays usable</td></tr>
 *   <tr><td>{@link javino.CommandReplacedException}</td><td>a later command took the place of one that waited</td><td>sending</td>
 *     <td>stays usable</td></tr>
 *   <tr><td>{@link javino.PortInterruptedException}</td><td>the calling thread was interrupted</td><td>any call that waits</td>
 *     <td>stays usable</td></tr>
 *   <tr><td>{@link javino.PortGoneException}</td><td>the port was closed, or its device has gone</td><td>reading, writing</td>
 *     <td>can be opened anew when the device is back</td></tr>
 * </table>
 */
package javino;
