/**
 * Opens serial devices by their names or by their USB identities, through jSerialComm.
 *
 * <p>{@link javino.serial.SerialPorts} lists the devices and finds out why a device cannot be opened.
 */
package javino.serial;
