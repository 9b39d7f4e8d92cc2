package javino.serial;

import java.util.Optional;
import java.util.OptionalInt;

/**
 * The operating system's description of a serial device.
 *
 * @param name the port's name for {@link javino.link.Link#open}: {@code ttyACM0}, {@code COM8}
 * @param path the port's path in the file system; on Windows the port's name
 * @param product the device's own name, if any
 * @param manufacturer the device's manufacturer, if known
 * @param vendorId the USB vendor's number, if it is a USB device
 * @param productId the product's number, if it is a USB device
 * @param serialNumber the device's serial number, if it has one
 */
public record SerialPortInfo(
        String name,
        String path,
        Optional<String> product,
        Optional<String> manufacturer,
        OptionalInt vendorId,
        OptionalInt productId,
        Optional<String> serialNumber) {
    /** Returns the port's USB identity: {@code usb:2341:0043}, or {@code usb:2341:0043:SERIAL}. Empty if the port is not on USB. */
    public Optional<String> usbName() {
        if (vendorId.isEmpty() || productId.isEmpty()) {
            return Optional.empty();
        }
        String model =
                String.format("%s:%04x:%04x", UsbTransportProvider.SCHEME, vendorId.getAsInt(), productId.getAsInt());
        return Optional.of(serialNumber.map(number -> model + ':' + number).orElse(model));
    }
}
