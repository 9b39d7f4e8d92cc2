package javino.serial;

import java.io.File;
import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;

/**
 * The name and the path of a serial device. A name without a slash is {@code /dev/NAME} on Linux and macOS, and the device's own name on
 * Windows.
 */
record SerialDevice(String name, String path) {
    private static final String DOS_NAMESPACE = "\\\\.\\";

    static SerialDevice of(String name) {
        return of(name, System.getProperty("os.name", ""));
    }

    static SerialDevice of(String name, String operatingSystem) {
        if (operatingSystem.startsWith("Windows")) {
            return new SerialDevice(
                    name, name.startsWith(DOS_NAMESPACE) ? name.substring(DOS_NAMESPACE.length()) : name);
        }
        return new SerialDevice(name, name.contains("/") ? name : "/dev/" + name);
    }

    /** The same address for all names of this device: the path with its symbolic links followed. */
    String canonicalAddress() {
        if (!hasNode()) {
            return path.toUpperCase(Locale.ROOT); // COM8 and com8 are one port
        }
        try {
            return Path.of(path).toRealPath().toString();
        } catch (IOException | InvalidPathException e) {
            return path; // nothing is there, so there is no other name
        }
    }

    boolean exists() {
        return !hasNode() || new File(path).exists(); // without a device file, only the driver knows
    }

    /** Returns whether the device has a file, as it does everywhere but on Windows. */
    boolean hasNode() {
        return path.contains("/");
    }
}
