package javino;

import com.fazecast.jSerialComm.SerialPort;

/** A serial device. */
final class SerialTransport implements Transport {
    private final SerialPort port;
    private final String name;
    private final LineSettings line;

    private SerialTransport(SerialPort port, String name, LineSettings line) {
        this.port = port;
        this.name = name;
        this.line = line;
    }

    static SerialTransport open(String name, LineSettings line) throws PortException {
        SerialPort port = SerialPort.getCommPort(name);
        port.setBaudRate(line.baud());
        port.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, 100, 0);
        if (!port.openPort()) {
            throw new PortFaultException(name, "port " + name + " cannot be opened (driver's code " + port.getLastErrorCode() + ")", null);
        }
        return new SerialTransport(port, name, line);
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public LineSettings line() {
        return line;
    }

    @Override
    public int read(byte[] b, int off, int len, int timeoutMillis) throws PortException {
        long deadline = System.nanoTime() + timeoutMillis * 1_000_000L;
        int count = port.readBytes(b, len, off);
        while (count == 0 && deadline - System.nanoTime() > 0) {
            count = port.readBytes(b, len, off);
        }
        if (count < 0) {
            throw new PortGoneException(name, "port " + name + " is gone");
        }
        return count;
    }

    @Override
    public void write(byte[] b, int off, int len, int timeoutMillis) throws PortException {
        if (port.writeBytes(b, len, off) != len) {
            throw new PortGoneException(name, "port " + name + " is gone");
        }
    }

    @Override
    public void close() {
        port.closePort();
    }
}
