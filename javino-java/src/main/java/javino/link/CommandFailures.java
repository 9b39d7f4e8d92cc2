package javino.link;

import java.util.List;
import javino.ActionRefusedException;
import javino.ActionUnconfirmedException;
import javino.Frame;
import javino.PortException;
import javino.session.CommandOutcome;
import javino.session.ComputerSession;
import javino.wire.CommandItem;

/** Explains why a board has not carried out a command. Guarded by the line's lock. */
final class CommandFailures {
    private final String port;
    private final ComputerSession<Command> session;

    CommandFailures(String port, ComputerSession<Command> session) {
        this.port = port;
        this.session = session;
    }

    /** Returns the exception for an outcome, or null if the board has carried the command out. */
    PortException of(Command command, CommandOutcome outcome) {
        String text = command.text();
        return switch (outcome) {
            case DONE -> null;
            case REFUSED ->
                new ActionRefusedException(
                        port,
                        command.rule() == null
                                ? "the board at port " + port + " refuses \"" + text + "\": "
                                        + ActionCheck.refusal(
                                                text, session.vocabulary().orElse(List.of()))
                                : "the board at port " + port + " refuses " + text
                                        + ": it has no room for the rule, or cannot watch it");
            case FAILED ->
                new ActionRefusedException(
                        port,
                        "the board at port " + port + " began \"" + text
                                + "\", and has reported that it could not carry it out");
            case UNCONFIRMED ->
                new ActionUnconfirmedException(
                        port,
                        "port " + port + " did not say that it acted on \"" + text
                                + "\"; it may have, or the board does not run any more");
            case TOO_LONG -> new ActionRefusedException(port, tooLong(command));
        };
    }

    private String tooLong(Command command) {
        boolean isRule = command.rule() != null;
        String sent = isRule ? command.rule().text() : command.text();
        int most = session.longestText(isRule);
        return "the board at port " + port + " takes no " + (isRule ? "rule" : "command") + " of "
                + sent.length() + " bytes, " + most + " at most"
                + (most < CommandItem.MAX_TEXT
                        ? ", as much as its memory holds: give the board more, as JavinoSized<600> javino; does"
                        : "")
                + ": " + (isRule ? command.text() : Frame.quoted(sent));
    }
}
