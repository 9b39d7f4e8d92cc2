package javino.tcp;

import java.io.IOException;
import java.net.Socket;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.cert.CertificateException;
import java.security.cert.CertificateExpiredException;
import java.security.cert.CertificateNotYetValidException;
import java.security.cert.X509Certificate;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.Date;
import java.util.Optional;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.X509ExtendedTrustManager;

/**
 * Trusts a board only if it shows the certificate that the folder has for it. Ignores the certificate's issuer and name. If the folder
 * has no certificate of the board, trusts the certificate that the board shows. {@link #pin} then stores this certificate. The messages
 * of exceptions are for a person.
 */
final class PinnedCertificate extends X509ExtendedTrustManager {
    private static final System.Logger LOG = System.getLogger(PinnedCertificate.class.getName());

    private final TlsFolder folder;
    private final TcpAddress address;
    private final Optional<X509Certificate> expected;
    private final Date now;
    private X509Certificate shown;

    PinnedCertificate(TlsFolder folder, TcpAddress address, Date now) throws IOException {
        this.folder = folder;
        this.address = address;
        this.expected = folder.boardAt(address);
        this.now = now;
    }

    /** Returns the trusted certificate that the board has shown, or null. */
    X509Certificate shown() {
        return shown;
    }

    /** If the folder has no certificate of the board, stores the trusted one and logs its fingerprint. */
    void pin(String port) throws IOException, GeneralSecurityException {
        if (folder.boardAt(address).isPresent()) {
            return;
        }
        folder.keep(address, shown);
        LOG.log(
                System.Logger.Level.INFO,
                "port " + port + ": this is the first connection to the board, so its certificate, "
                        + TlsFolder.fingerprint(shown) + ", is kept in " + folder.fileOf(address)
                        + ", and no other one will be accepted");
    }

    private void check(X509Certificate[] chain) throws CertificateException {
        X509Certificate found = chain[0];
        Path file = folder.fileOf(address);
        if (expected.isPresent() && !expected.get().equals(found)) {
            throw new CertificateException("the board shows another certificate than the one in " + file + ": expected "
                    + TlsFolder.fingerprint(expected.get()) + ", found " + TlsFolder.fingerprint(found)
                    + ". Was the board exchanged, or its certificate renewed? Then delete that file, or put the new certificate there."
                    + " If not, somebody is between this computer and the board, or this is not your board");
        }
        try {
            found.checkValidity(now);
        } catch (CertificateExpiredException e) {
            throw new CertificateException("the board's certificate (" + TlsFolder.fingerprint(found) + ") expired on "
                    + day(found.getNotAfter()) + ", and this computer's clock says " + day(now)
                    + ". Put a new one on the board, and delete " + file + ", or put the new one there");
        } catch (CertificateNotYetValidException e) {
            throw new CertificateException("the board's certificate (" + TlsFolder.fingerprint(found)
                    + ") is valid from " + day(found.getNotBefore()) + " on, and this computer's clock says " + day(now)
                    + ". Set the clock that is wrong");
        }
        shown = found;
    }

    private static LocalDate day(Date date) {
        return LocalDate.ofInstant(date.toInstant(), ZoneOffset.UTC);
    }

    @Override
    public void checkServerTrusted(X509Certificate[] chain, String type, Socket socket) throws CertificateException {
        check(chain);
    }

    @Override
    public void checkServerTrusted(X509Certificate[] chain, String type, SSLEngine engine) throws CertificateException {
        check(chain);
    }

    @Override
    public void checkServerTrusted(X509Certificate[] chain, String type) throws CertificateException {
        check(chain);
    }

    @Override
    public void checkClientTrusted(X509Certificate[] chain, String type, Socket socket) {
        throw new UnsupportedOperationException("only for the end that connects");
    }

    @Override
    public void checkClientTrusted(X509Certificate[] chain, String type, SSLEngine engine) {
        throw new UnsupportedOperationException("only for the end that connects");
    }

    @Override
    public void checkClientTrusted(X509Certificate[] chain, String type) {
        throw new UnsupportedOperationException("only for the end that connects");
    }

    @Override
    public X509Certificate[] getAcceptedIssuers() {
        return new X509Certificate[0];
    }
}
