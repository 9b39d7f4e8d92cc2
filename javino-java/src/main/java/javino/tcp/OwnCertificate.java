package javino.tcp;

import java.net.Socket;
import java.security.Principal;
import java.security.PrivateKey;
import java.security.cert.X509Certificate;
import java.util.List;
import java.util.Optional;
import javax.net.ssl.X509ExtendedKeyManager;

/**
 * Shows the computer's certificate to any board that asks for one. Ignores which issuers the board trusts. Remembers whether a board
 * asked.
 */
final class OwnCertificate extends X509ExtendedKeyManager {
    private static final String ALIAS = "computer";

    private final Optional<TlsFolder.Identity> own;
    private volatile boolean asked;

    OwnCertificate(Optional<TlsFolder.Identity> own) {
        this.own = own;
    }

    boolean isAskedFor() {
        return asked;
    }

    boolean isPresent() {
        return own.isPresent();
    }

    @Override
    public String chooseClientAlias(String[] types, Principal[] issuers, Socket socket) {
        asked = true;
        boolean isTaken =
                own.isPresent() && List.of(types).contains(own.get().key().getAlgorithm());
        return isTaken ? ALIAS : null;
    }

    @Override
    public X509Certificate[] getCertificateChain(String alias) {
        return own.map(TlsFolder.Identity::chain).orElse(null);
    }

    @Override
    public PrivateKey getPrivateKey(String alias) {
        return own.map(TlsFolder.Identity::key).orElse(null);
    }

    @Override
    public String[] getClientAliases(String type, Principal[] issuers) {
        return own.map(identity -> new String[] {ALIAS}).orElse(null);
    }

    @Override
    public String[] getServerAliases(String type, Principal[] issuers) {
        return null;
    }

    @Override
    public String chooseServerAlias(String type, Principal[] issuers, Socket socket) {
        return null;
    }
}
