package javino.serial;

import java.util.List;

/**
 * Tells which serial devices on USB there are. The serial driver's list is built in; programs add what that does not know, and tests add
 * devices that do not exist, through {@link java.util.ServiceLoader}: a class with a public constructor without arguments, named in
 * {@code META-INF/services/javino.serial.UsbPorts}.
 */
@FunctionalInterface
public interface UsbPorts {
    /** The devices there are now. Called from any thread, about once a second while a device is waited for. */
    List<UsbPort> now();
}
