;;; argo.el --- AgentSpeak of Jason, with ARGO's language server by eglot  -*- lexical-binding: t; -*-

;; In ~/.emacs.d/init.el:
;;   (load "/path/to/argo.el")
;;   (setq argo-jar "/path/to/argo.jar")
;; Emacs 29 has eglot; for Emacs 28: M-x package-install RET eglot, or Debian's elpa-eglot.

(require 'eglot)

(defgroup argo nil "Agents on robots." :group 'languages)

(defcustom argo-jar "~/argo/argo.jar" "The path of argo.jar." :type 'file)

(defvar agentspeak-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?/ ". 124b" table)
    (modify-syntax-entry ?* ". 23" table)
    (modify-syntax-entry ?\n "> b" table)
    (modify-syntax-entry ?_ "w" table)
    (dolist (operator '(?+ ?- ?! ?& ?| ?< ?> ?= ?: ?~ ?@ ?^))
      (modify-syntax-entry operator "." table))
    table)
  "Comments as in Java; operators are no parts of words.")

(defconst agentspeak-keywords
  '(("\\_<\\(not\\|true\\|false\\|if\\|else\\|elif\\|for\\|while\\|include\\|begin\\|end\\|MAS\\|agents\\|agentArchClass\\)\\_>"
     . font-lock-keyword-face)
    ("\\(?:\\_<argo\\|[^a-zA-Z0-9_)]\\)\\.[a-z][a-zA-Z0-9_]*" . font-lock-builtin-face)
    ("[-+^]?!!?\\([a-z][a-zA-Z0-9_]*\\)" 1 font-lock-function-name-face)
    ("\\_<[A-Z_][a-zA-Z0-9_]*" . font-lock-variable-name-face))
  "Colours, as far as a person needs them.")

(define-derived-mode agentspeak-mode prog-mode "AgentSpeak"
  "Programs of agents."
  (setq-local comment-start "// ")
  (setq-local comment-start-skip "//+ *")
  (setq-local font-lock-defaults '(agentspeak-keywords)))

(define-derived-mode mas2j-mode agentspeak-mode "Jason project"
  "Projects of Jason.")

(add-to-list 'auto-mode-alist '("\\.asl\\'" . agentspeak-mode))
(add-to-list 'auto-mode-alist '("\\.mas2j\\'" . mas2j-mode))

(defun argo-server (&rest _)
  "Return the command of the language server."
  (list "java" "-XX:+UseSerialGC" "-Xmx512m" "-jar" (expand-file-name argo-jar) "lsp"))

(add-to-list 'eglot-server-programs '((agentspeak-mode mas2j-mode) . argo-server))
(add-hook 'agentspeak-mode-hook #'eglot-ensure)

;; the debugger: start agents with argo_debug=4711, then M-x dape
(with-eval-after-load 'dape
  (add-to-list 'dape-configs
               '(argo modes (agentspeak-mode) host "127.0.0.1" port 4711 :type "argo" :request "attach")))

(provide 'argo)
;;; argo.el ends here
