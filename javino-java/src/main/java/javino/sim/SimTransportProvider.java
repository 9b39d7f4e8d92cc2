package javino.sim;

import java.util.List;
import javino.LineSettings;
import javino.PortException;
import javino.Transport;
import javino.TransportProvider;

/** Opens {@code sim:name}: the simulated board with the given name. */
public final class SimTransportProvider implements TransportProvider {
    @Override
    public String scheme() {
        return SimulatedBoards.SCHEME;
    }

    @Override
    public Transport open(String address, LineSettings line) throws PortException {
        return SimulatedBoards.open(address, line);
    }

    @Override
    public List<String> ports() {
        return SimulatedBoards.names().stream().map(this::port).toList();
    }

    @Override
    public boolean isPresent(String address) {
        return SimulatedBoards.names().contains(address);
    }
}
