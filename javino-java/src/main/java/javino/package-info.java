/**
 * Exchanges messages between a program and a microcontroller board over a serial line. Speaks versions 1 and 2 of the Javino protocol.
 *
 * <p>Programs use {@link javino.link.Link}. A link opens a port for one owner, asks the board until it answers, and exchanges messages at
 * the pace of the line. {@link javino.link.Javino} is a classic interface on top of links. Below a link, a {@link javino.Transport} moves
 * bytes. {@link javino.Frame} and {@link javino.FrameDecoder} turn bytes into messages:
 *
 * <pre>
 * board --bytes--&gt; Transport --&gt; FrameDecoder --&gt; Link --messages--&gt; program
 * board &lt;--bytes-- Transport &lt;-- Frame &lt;-------- Link &lt;--messages-- program
 * </pre>
 *
 * <p>{@link javino.Transports} finds a transport by the port's name. {@code ttyACM0}, {@code /dev/pts/3} and {@code COM8} are serial
 * devices. {@code usb:2341:0043} is a serial device by its USB identity. {@code tcp://robot:4000} is a board on the network.
 * {@code sim:robot} is a {@link javino.sim.SimulatedBoard} of this program. A {@link javino.TransportProvider} can add other kinds.
 * {@code javino.sim.FakeBoard}, in the library {@code argo-testkit}, is a simulated board for tests.
 *
 * <table>
 *   <caption>The exceptions. Each is a {@link javino.PortException} with the port's name</caption>
 *   <tr><th>exception</th><th>thrown when</th><th>by</th><th>then the port</th></tr>
 *   <tr><td>{@link javino.NoSuchPortException}</td><td>the port or scheme does not exist; the message lists others</td><td>opening</td>
 *     <td>is not open</td></tr>
 *   <tr><td>{@link javino.PortBusyException}</td><td>the port is open already; {@code owner()} names its owner</td><td>opening</td>
 *     <td>is not open</td></tr>
 *   <tr><td>{@link javino.PortPermissionException}</td><td>this user has no permission; the message says what to do</td><td>opening</td>
 *     <td>is not open</td></tr>
 *   <tr><td>{@link javino.PortFaultException}</td><td>the driver refuses for another reason; the message has its code</td><td>opening</td>
 *     <td>is not open</td></tr>
 *   <tr><td>{@link javino.PortTimeoutException}</td><td>an operation was not done in time</td><td>reading, writing</td>
 *     <td>stays usable</td></tr>
 *   <tr><td>{@link javino.ActionRefusedException}</td><td>a version 2 board does not know the action, or refuses it</td><td>sending</td>
 *     <td>stays usable</td></tr>
 *   <tr><td>{@link javino.ActionUnconfirmedException}</td><td>a version 2 board did not confirm the action</td><td>sending</td>
 *     <td>stays usable</td></tr>
 *   <tr><td>{@link javino.CommandWithdrawnException}</td><td>a command's time limit ended before it began to go out</td><td>sending</td>
 *     <td>stays usable</td></tr>
 *   <tr><td>{@link javino.CommandReplacedException}</td><td>a later command replaced a waiting command</td><td>sending</td>
 *     <td>stays usable</td></tr>
 *   <tr><td>{@link javino.PortInterruptedException}</td><td>the calling thread was interrupted</td><td>any call that waits</td>
 *     <td>stays usable</td></tr>
 *   <tr><td>{@link javino.PortGoneException}</td><td>the port was closed, or its device has gone</td><td>reading, writing</td>
 *     <td>can be opened anew when the device is back</td></tr>
 * </table>
 */
package javino;
