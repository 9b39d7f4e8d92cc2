package javino.serial;

/**
 * A serial device on USB, and what it says of itself.
 *
 * @param device the name of its serial device now, as {@link javino.Transports#open} takes it: {@code ttyACM0}, {@code COM8}
 * @param vendor the number of its vendor, 0 to 0xFFFF: 0x2341
 * @param product the number of the product, 0 to 0xFFFF: 0x0043
 * @param serialNumber its own number; empty if it has none
 */
public record UsbPort(String device, int vendor, int product, String serialNumber) {
    /** The port by its USB identity: {@code usb:2341:0043}, with {@code :SERIAL} behind it if it has a serial number. */
    public String name() {
        String model = String.format("%s:%04x:%04x", UsbTransportProvider.SCHEME, vendor, product);
        return serialNumber.isEmpty() ? model : model + ':' + serialNumber;
    }
}
