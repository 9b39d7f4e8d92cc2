package javino.serial;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.util.List;
import java.util.Set;
import javino.NoSuchPortException;
import javino.PortBusyException;
import javino.PortException;
import javino.PortFaultException;
import javino.PortPermissionException;

/** Explains why a serial device cannot be opened, and what to do. */
final class SerialPortErrors {
    /** Groups that a user should not join only to reach a board. */
    private static final Set<String> SYSTEM_GROUPS = Set.of("root", "wheel");

    private SerialPortErrors() {}

    static PortException cannotOpen(SerialDevice device, int code, List<String> ports) {
        DriverErrorCode failure =
                device.hasNode() ? DriverErrorCode.posix(code, device.exists()) : DriverErrorCode.windows(code);
        return switch (failure) {
            case NO_SUCH_PORT -> noSuchPort(device, ports);
            case BUSY -> new PortBusyException(device.name(), holders(device));
            case OPEN_IN_THIS_PROGRAM -> new PortBusyException(device.name(), "another part of this program");
            case NO_PERMISSION ->
                new PortPermissionException(
                        device.name(),
                        "user " + System.getProperty("user.name", "this user") + " may not open port " + device.name()
                                + "; " + permissionRemedy(device));
            case OTHER ->
                new PortFaultException(
                        device.name(),
                        "port " + device.name() + " cannot be opened; "
                                + (code == DriverOpening.UNKNOWN_CODE
                                        ? "the driver is opening another device, so its reason is not known; try again"
                                        : "the driver's code is " + code),
                        null);
        };
    }

    static NoSuchPortException noSuchPort(SerialDevice device, List<String> ports) {
        String what = device.exists() && device.hasNode()
                ? device.path() + " is not a serial device, or nothing is connected to it"
                : device.hasNode()
                        ? "there is no port " + device.name() + " (looked for " + device.path() + ")"
                        : "there is no port " + device.name();
        String present = ports.isEmpty()
                ? "there are no serial ports now (is the board plugged in?)"
                : "the serial ports there are: " + String.join(", ", ports);
        String hint =
                device.hasNode() ? "; a pseudo-terminal is given by its path, as /dev/pts/3" + dosHint(device) : "";
        return new NoSuchPortException(device.name(), what + "; " + present + hint);
    }

    private static String dosHint(SerialDevice device) {
        return device.name().matches("(?i)com[0-9]+")
                ? ", and for a board at ttyACM0 \"sudo ln -s ttyACM0 " + device.path() + "\" makes this name work"
                : "";
    }

    private static String holders(SerialDevice device) {
        List<String> holders = DeviceHolders.of(device);
        return holders.isEmpty() ? "another program" : String.join(" and ", holders);
    }

    static String permissionRemedy(SerialDevice device) {
        try {
            PosixFileAttributes node = Files.readAttributes(Path.of(device.path()), PosixFileAttributes.class);
            return permissionRemedy(device.path(), node.group().getName(), node.permissions());
        } catch (IOException | UnsupportedOperationException e) {
            return permissionRemedy(
                    device.path(), "dialout", Set.of(PosixFilePermission.GROUP_READ, PosixFilePermission.GROUP_WRITE));
        }
    }

    static String permissionRemedy(String path, String group, Set<PosixFilePermission> permissions) {
        boolean groupMay =
                permissions.containsAll(Set.of(PosixFilePermission.GROUP_READ, PosixFilePermission.GROUP_WRITE));
        if (groupMay && !SYSTEM_GROUPS.contains(group)) {
            return path + " is for the group " + group + ": run \"sudo usermod -aG " + group
                    + " $USER\", then log out and in again";
        }
        return path + " may be opened only by its owner: run \"sudo chmod a+rw " + path + "\"";
    }

    static PortFaultException noNativeLibrary(String name, LinkageError cause) {
        return new PortFaultException(
                name,
                "port " + name + " cannot be opened: jSerialComm could not unpack or load its native "
                        + "library in " + System.getProperty("java.io.tmpdir") + " nor in "
                        + System.getProperty("user.home")
                        + "/.jSerialComm; make one of them writable and executable, name another directory with "
                        + "-Djava.io.tmpdir=DIRECTORY, or one that holds the library with -DjSerialComm.library.path=DIRECTORY ("
                        + cause.getMessage() + ")",
                cause);
    }
}
