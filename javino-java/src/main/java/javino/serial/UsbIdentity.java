package javino.serial;

import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javino.NoSuchPortException;

/**
 * The identity of a device on USB, independent of its name: {@code 2341:0043}, or {@code 2341:0043:SERIAL}.
 *
 * @param serialNumber the device's serial number, or empty for any. Upper and lower case are equal, because Windows changes the case
 */
record UsbIdentity(int vendor, int product, String serialNumber) {
    private static final Pattern FORM = Pattern.compile("([0-9A-Fa-f]{1,4}):([0-9A-Fa-f]{1,4})(?::(.+))?");
    private static final int HEX = 16;

    static UsbIdentity of(String port, String address) throws NoSuchPortException {
        Matcher form = FORM.matcher(address);
        if (!form.matches()) {
            throw new NoSuchPortException(
                    port,
                    "\"" + port + "\" is no USB identity; that is usb:VENDOR:PRODUCT or "
                            + "usb:VENDOR:PRODUCT:SERIAL, the first two in hexadecimal digits, as usb:2341:0043");
        }
        return new UsbIdentity(
                Integer.parseInt(form.group(1), HEX),
                Integer.parseInt(form.group(2), HEX),
                form.group(3) == null ? "" : form.group(3));
    }

    boolean fits(SerialPortInfo port) {
        return port.vendorId().equals(OptionalInt.of(vendor))
                && port.productId().equals(OptionalInt.of(product))
                && (serialNumber.isEmpty()
                        || port.serialNumber()
                                .filter(serialNumber::equalsIgnoreCase)
                                .isPresent());
    }
}
